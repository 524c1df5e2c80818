"""What a part of the report is: blocks under a title, made of a case."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from markupsafe import Markup

from exoid.report.parts.case import Case
from exoid.report.pictures.panel import Picture
from exoid.report.tables.table import Table


@dataclass(frozen=True, eq=False)
class Group:
    """Blocks within an element of HTML, of a class where it has one."""

    tag: str
    blocks: "Sequence[Block]"
    style: str = ""


# A sentence is a paragraph, several are a list, those with names a list of what the names mean;
# Markup is HTML already. A table or a list that holds nothing is left out.
Block = str | Sequence[str] | Mapping[str, str] | Table | Picture | Group


@dataclass(frozen=True, eq=False)
class Section:
    """What is shown of a case under `title`; nothing where there are no blocks."""

    name: str
    title: str
    blocks: Callable[[Case], Iterable[Block]]


def section(name: str, title: str) -> Callable[[Callable[[Case], Iterable[Block]]], Section]:
    """Makes the function below it a section."""
    return lambda blocks: Section(name, title, blocks)


def element(tag: str, words: str, style: str = "") -> Markup:
    """Words as HTML, with no symbol typeset."""
    opened = Markup('<{} class="{}">').format(tag, style) if style else Markup("<{}>").format(tag)
    return Markup("{}{}</{}>").format(opened, words, tag)


def some(figures: Sequence[Picture]) -> Iterator[Block]:
    """Figures beside each other, of which paper has two."""
    if len(figures) > 2:
        words = f"On paper are two of the {len(figures)} figures; the others are on the screen."
        yield element("p", words, "paper")
    yield Group("div", figures, "grid some")
