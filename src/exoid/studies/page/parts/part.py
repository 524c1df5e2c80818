"""What a part of a study's page is: blocks under a title, made of all answers."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass

from exoid.report.parts.origin import Origin
from exoid.report.sections.blocks import Block
from exoid.studies.statistics.asked import Answers

PICTURED = 4  # quantities that have pictures; the others stand in the tables
COMPARED = 2  # that have pictures of differences


@dataclass(frozen=True, eq=False)
class Told:
    """All that a page is made of."""

    answers: Answers
    origin: Origin
    title: str


@dataclass(frozen=True, eq=False)
class Part:
    """What is shown under `title`; nothing where there are no blocks."""

    name: str
    title: str
    blocks: Callable[[Told], Iterable[Block]]


def part(name: str, title: str) -> Callable[[Callable[[Told], Iterable[Block]]], Part]:
    """Makes the function below it a part of the page."""
    return lambda blocks: Part(name, title, blocks)
