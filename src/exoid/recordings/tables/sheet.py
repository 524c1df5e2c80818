"""A table as a file holds it, before anybody knows what its columns mean."""

from dataclasses import dataclass

import numpy as np

from exoid.files.text_file import Notes
from exoid.files.visible import visible

Cells = np.ndarray | tuple[str, ...]  # numbers, NaN where one is missing; or what a cell says


@dataclass(frozen=True, eq=False)
class Column:
    """A column under the name that its file gives it, with the unit that the file says."""

    name: str
    cells: Cells
    unit: str = ""

    @property
    def numeric(self) -> bool:
        return isinstance(self.cells, np.ndarray)

    @property
    def texts(self) -> tuple[str, ...]:
        """What its cells say, a number as short as it is exact."""
        if not isinstance(self.cells, np.ndarray):
            return tuple(self.cells)
        return tuple("" if cell != cell else repr(cell) for cell in self.cells.tolist())


@dataclass(frozen=True)
class Place:
    """Where a sample stands in its file, in words: line 12, row 3, sample 0."""

    word: str = "sample"
    first: int = 0
    rows: tuple[int, ...] | None = None  # that are left of it; None for all

    def __call__(self, row: int) -> str:
        return f"{self.word} {self.first + (row if self.rows is None else self.rows[row])}"


@dataclass(frozen=True, eq=False)
class Sheet:
    """Columns of one length, and what their reader noticed."""

    columns: tuple[Column, ...]
    place: Place = Place()
    rate: float | None = None  # Hz, where the file says it apart from its columns
    notes: Notes = ()
    time: str = ""  # what its program calls the time, where that sounds like none
    ask: str = 'columns={{"{}": "..."}}'  # how its owner names a column

    @property
    def names(self) -> list[str]:
        return [column.name for column in self.columns]

    def column(self, name: str) -> Column | None:
        """The column of this name; of several, the first."""
        return next((column for column in self.columns if column.name == name), None)


def printable(name: object) -> str:
    """A name on one line, with nothing in it that would steer a terminal."""
    return visible(" ".join(str(name).split()))


def listed(names: list[str], most: int = 12) -> str:
    """Names in a sentence, of many the first."""
    more = len(names) - most
    return ", ".join(names[:most]) + (f" and {more} more" if more > 0 else "")
