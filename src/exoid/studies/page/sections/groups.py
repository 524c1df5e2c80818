"""Groups, or a dose, compared."""

from collections.abc import Iterator

from exoid.report.sections.blocks import Block, Group, element
from exoid.report.words.text import by_reason, quantity_words
from exoid.studies.page.parts.part import Told, part
from exoid.studies.page.parts.presence import lacking
from exoid.studies.page.parts.tables import comparisons
from exoid.studies.page.parts.words import column_words, grouped, reasons
from exoid.studies.page.pictures.intervals import effects
from exoid.studies.statistics.asked import Answers
from exoid.studies.statistics.groups import Comparison

HOW = (
    "All drops of all days enter a mixed model at once: people, their sides and days are random, "
    "and the error of each estimate is known, so a drop that tells little weighs little. Intervals "
    "and p rest on the number of people, not of drops."
)


@part("groups", "Groups")
def groups(told: Told) -> Iterator[Block]:
    """Differences and, where sessions were named, those of the change."""
    asked = told.answers.asked
    if not asked.by:
        return
    by = column_words(asked.by)
    when = f" at {asked.before}" if asked.before else ""
    yield from compared(told.answers, "groups", f"By {by}{when}")
    if asked.before:
        title = f"Change from {asked.before} to {asked.after}, by {by}"
        yield element("h3", title)
        yield from compared(told.answers, "change_by_group", title)
    yield Group("details", [element("summary", "How groups are compared"), HOW])


def compared(answers: Answers, kind: str, title: str) -> Iterator[Block]:
    """Sentences of what is sure, the table, the picture."""
    told = [
        (found, each.corrected[kind], each.among[kind])
        for each in answers.each
        if isinstance(found := getattr(each, kind), Comparison)
    ]
    yield [grouped(*each) for each in told if each[1] < 0.05] or (
        ["No difference that is sure."] if told else []
    )
    yield comparisons(answers, kind, title)
    picture = effects([found for found, *_ in told]) if kind == "groups" else None
    if picture is not None:
        yield picture
    notes = {note: None for found, *_ in told for note in found.notes}
    yield list(notes)
    missing = by_reason(
        (quantity_words(each.quantity), one)
        for each in answers.each
        if isinstance(getattr(each, kind), Comparison)
        for one in lacking(each)
    )
    yield [f"{', '.join(names)}: {one}" for one, names in missing.items()]
    yield reasons(answers, kind)
