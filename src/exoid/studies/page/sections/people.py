"""Every person as a point that opens."""

from collections.abc import Iterator

from markupsafe import Markup

from exoid.report.sections.blocks import Block, Group
from exoid.studies.page.parts.part import PICTURED, Told, part
from exoid.studies.page.pictures.people import people as drawn

FIND = Markup("""\
<p class="screen"><label for="find">Open a person: </label>
<input id="find" list="ids" autocomplete="off" spellcheck="false" placeholder="id">
<datalist id="ids"></datalist></p>""")


@part("people", "People")
def people(told: Told) -> Iterator[Block]:
    """A picture for each of the first quantities."""
    answers = told.answers
    if not answers.each:
        return
    yield FIND
    pictures = [drawn(each, answers.asked.by) for each in answers.each[:PICTURED]]
    yield Group("div", pictures, "grid" if len(pictures) > 1 else "")
    if len(answers.each) > PICTURED:
        yield (
            f"These are the first {PICTURED} of {len(answers.each)} quantities; name others by "
            "--quantity."
        )
