"""What a part of the report is: blocks under a title, made of a case."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass

from exoid.report.parts.case import Case
from exoid.report.sections.blocks import Block


@dataclass(frozen=True, eq=False)
class Section:
    """What is shown of a case under `title`; nothing where there are no blocks."""

    name: str
    title: str
    blocks: Callable[[Case], Iterable[Block]]


def section(name: str, title: str) -> Callable[[Callable[[Case], Iterable[Block]]], Section]:
    """Makes the function below it a section."""
    return lambda blocks: Section(name, title, blocks)
