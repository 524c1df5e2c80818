"""What failed, what was asked, and how to make the page again."""

from collections.abc import Iterator

from exoid.report.sections.blocks import Block
from exoid.report.sections.made import made
from exoid.studies.page.parts.copies import copies
from exoid.studies.page.parts.correction import correction
from exoid.studies.page.parts.part import Told, part
from exoid.studies.page.parts.tables import failures


@part("failures", "Recordings that failed")
def failed(told: Told) -> Iterator[Block]:
    table = failures(told.answers.study.recordings)
    if table.rows:
        yield table
    yield copies(told.answers.study.recordings)


@part("origin", "Where this comes from")
def origin(told: Told) -> Iterator[Block]:
    answers = told.answers
    notes = {note: None for each in answers.each for note in notes_of(each)}
    yield list(notes)
    yield correction(answers)
    yield from made(told.origin)


def notes_of(answer) -> list[str]:
    return [f"{answer.quantity}: {note}" for note in answer.values.notes]
