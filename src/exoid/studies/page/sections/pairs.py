"""Left against right, before against after."""

from collections.abc import Iterator

from exoid.report.sections.blocks import Block, Group, element
from exoid.studies.page.parts.part import COMPARED, Told, part
from exoid.studies.page.parts.pictured import pictured
from exoid.studies.page.parts.tables import FEWEST_SLOPED, agreements
from exoid.studies.page.parts.words import reasons
from exoid.studies.page.pictures.bland_altman import bland_altman
from exoid.studies.statistics.agreement import Agreement
from exoid.studies.statistics.asked import Answers

WORDS = {
    "mean difference": "Of people; who is known better weighs more.",
    "95 % of people between": "The limits of agreement: the mean difference ± 1.96 standard "
    "deviations of the differences, each person counting the same; each limit with half the width "
    "of its own 95 % interval.",
    "grows with size": "Whether the difference depends on the size of the value; not told of fewer "
    f"than {FEWEST_SLOPED} people.",
    "due to errors": "The share of the differences' variance that the errors of the estimates "
    "explain; the rest is in the legs, the days and the people.",
}


@part("change", "Before and after")
def change(told: Told) -> Iterator[Block]:
    asked = told.answers.asked
    if asked.before:
        yield from paired(told.answers, "change", f"{asked.after} - {asked.before}")


@part("sides", "Left and right")
def sides(told: Told) -> Iterator[Block]:
    yield from paired(told.answers, "sides", "right - left")


def paired(answers: Answers, kind: str, title: str) -> Iterator[Block]:
    """The table, and a picture of each of the first quantities."""
    first = pictured(answers.each)[:COMPARED]
    found = [each for each in first if isinstance(getattr(each, kind), Agreement)]
    yield agreements(answers, kind, title)
    if found:
        yield Group("details", [element("summary", "What the columns mean"), WORDS])
    pictures = [bland_altman(getattr(each, kind), f"{kind}-{each.quantity}") for each in found]
    yield Group("div", pictures, "grid" if len(pictures) > 1 else "")
    yield reasons(answers, kind)
