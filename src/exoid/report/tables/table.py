"""A table, said once: a terminal prints it, a page sets it."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Literal

from markupsafe import Markup
from rich.box import SIMPLE_HEAD
from rich.console import Console
from rich.table import Table as Grid
from rich.text import Text

from exoid.files.visible import visible
from exoid.report.words.text import NOT_DETERMINED, heading, shortened, shown_unit
from exoid.report.words.typeset import formula

STACKED, SPANNING = 3, 5  # columns that a phone has room for, and half a sheet of paper
GAP = 2  # letters that a terminal needs between columns, at most
Cells = Sequence[str]


@dataclass(frozen=True)
class Column:
    """Cells, and what a terminal or a page makes of them where that differs."""

    cells: Cells
    units: Cells = ()  # a terminal has a column for them, a page says them behind each cell
    symbols: bool = False  # a page typesets them
    on_page: Cells | None = None  # what a page says instead, which has room for words
    head: str | None = None  # in a terminal
    only: Literal["both", "terminal", "page"] = "both"
    spare: int = 0  # a terminal that is too narrow goes without, the highest first
    brief: Cells = ()  # and has these instead
    shortest: int = 0  # letters to which a terminal that still is too narrow cuts a cell

    @property
    def paged(self) -> Cells:
        """The cells of a page."""
        cells = self.cells if self.on_page is None else self.on_page
        if self.symbols:
            return [formula(cell) for cell in cells]
        if not self.units:
            return cells
        return [with_unit(*both) for both in zip(cells, self.units, strict=True)]


@dataclass(frozen=True)
class Table:
    """Columns of equal length by their heads, the first of which names the rows.

    Columns that hold nothing are left out.
    """

    caption: str
    columns: Mapping[str, Column | Cells]
    title: str = ""  # in a terminal

    @property
    def paged(self) -> dict[str, Cells]:
        """The cells of a page by their heads."""
        each = {head: whole(column) for head, column in self.columns.items()}
        shown = {head: one.paged for head, one in each.items() if one.only != "terminal"}
        return {head: cells for head, cells in shown.items() if any(cells)}

    @property
    def heads(self) -> list[str]:
        return list(self.paged)

    @property
    def shape(self) -> str:
        """`stack`: a phone shows its rows below each other; `span`: paper gives it both columns."""
        many = len(self.paged)
        return " ".join(["stack"] * (many > STACKED) + ["span"] * (many > SPANNING))

    @property
    def rows(self) -> list[tuple[str, ...]]:
        return list(zip(*self.paged.values(), strict=True))


def whole(column: Column | Cells) -> Column:
    return column if isinstance(column, Column) else Column(column)


def with_unit(cell: str, unit: str) -> str:
    """A cell and its unit, where both say something."""
    plain = cell in ("", NOT_DETERMINED) or not shown_unit(unit) or isinstance(cell, Markup)
    return cell if plain else f"{cell} {unit}"


def print_table(table: Table, console: Console) -> None:
    """Without frame, under its title, as wide as the terminal at most: what is too long for it goes
    on in a second line, but for numbers with an error.
    """
    columns = fitted(table, console.width)
    drawn = Grid(box=SIMPLE_HEAD, show_edge=False, padding=(0, 1, 0, 0), header_style="bold")
    for head, cells in columns.items():
        whole_numbers = any("±" in cell for cell in cells)
        drawn.add_column(Text(visible(head, "\n")), overflow="fold", no_wrap=whole_numbers)
    for row in zip(*columns.values(), strict=True):
        drawn.add_row(*(Text(visible(cell, "\n")) for cell in row))
    if table.title:
        heading(console, table.title)
    console.print(drawn)


def fitted(table: Table, room: int) -> dict[str, Cells]:
    """The columns of a terminal by their heads, as far as it has room for them."""
    each = {head: whole(column) for head, column in table.columns.items()}
    each = {head: one for head, one in each.items() if one.only != "page"}
    for head, one in sorted(each.items(), key=lambda item: -item[1].spare):
        if one.spare and width(terminal(each)) > room:
            each[head] = replace(one, cells=one.brief)
    for head, one in each.items():
        if one.shortest:
            others = {name: other for name, other in each.items() if name != head}
            left = max(one.shortest, room - width(terminal(others)) - GAP)
            each[head] = replace(one, cells=[shortened(cell, left) for cell in one.cells])
    return terminal(each)


def terminal(each: Mapping[str, Column]) -> dict[str, Cells]:
    """Heads and cells of those that hold something; units in columns of their own."""
    shown = {}
    for name, one in each.items():
        shown[name if one.head is None else one.head] = one.cells
        if one.units:
            shown["unit"] = [shown_unit(each) for each in one.units]
    return {head: cells for head, cells in shown.items() if any(cells)}


def width(columns: Mapping[str, Cells]) -> int:
    """Letters that they take."""
    texts = [[*head.split("\n"), *cells] for head, cells in columns.items()]
    return sum(max(map(len, each)) + GAP for each in texts)
