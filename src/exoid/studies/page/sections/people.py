"""Every person as a point that opens."""

from collections.abc import Iterator

from markupsafe import Markup

from exoid.report.sections.blocks import Block, Group
from exoid.studies.page.parts.part import PICTURED, Told, part
from exoid.studies.page.parts.pictured import pictured
from exoid.studies.page.pictures.people import people as drawn
from exoid.studies.page.pictures.people import shown

FIND = Markup("""\
<p class="screen"><label for="find">Open a person: </label>
<input id="find" list="ids" autocomplete="off" spellcheck="false" placeholder="id">
<datalist id="ids"></datalist></p>""")


@part("people", "People")
def people(page: Told) -> Iterator[Block]:
    """A picture for each of the first quantities."""
    answers = page.answers
    if not answers.each:
        return
    yield FIND
    told = [each for each in pictured(answers.each) if shown(each, answers.asked).people]
    pictures = [drawn(each, answers.asked) for each in told[:PICTURED]]
    yield Group("div", pictures, "grid" if len(pictures) > 1 else "")
    if len(answers.each) > len(pictures):
        yield (
            f"These are {len(pictures)} of {len(answers.each)} quantities; name others by "
            "--quantity."
        )
