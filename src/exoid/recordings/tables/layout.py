"""Where names, units and samples stand in rows of cells that other people have laid out.

Above the samples may stand a title and a preamble; the last row above them holds the names, or the
units with the names above them; below them may stand another block.
"""

from collections import Counter
from dataclasses import dataclass
from itertools import accumulate

import numpy as np

from exoid.files.counted import counted
from exoid.recordings.tables.sheet import Column, Place, Sheet, listed, printable
from exoid.recordings.tables.units import is_unit, parted, plain

Cell = float | str  # NaN where it is empty
Row = list[Cell]

NO_TABLE = "holds no table of numbers. Export it with names, then one row a sample."
AXES = ("X", "Y", "Z", "x", "y", "z")
FRAMES = {"Frame", "Sub Frame"}
COMMENT = ("#", "%")
REMARKS = ("comment", "comments", "remark", "remarks", "kommentar", "bemerkung", "commentaire")
PROBED = 25  # rows to either side of the middle, which say what is a sample


@dataclass(frozen=True)
class Layout:
    """The rows that hold samples, and which of their columns hold numbers."""

    first: int
    end: int
    numeric: tuple[bool, ...]


def is_number(cell: Cell) -> bool:
    return isinstance(cell, float) and cell == cell


def is_missing(cell: Cell) -> bool:
    return isinstance(cell, float) and cell != cell


def is_empty(row: Row) -> bool:
    return all(is_missing(cell) for cell in row)


def sheet_of_rows(rows: list[Row], place: Place) -> Sheet:
    """The block of samples in these rows under its names.

    **Raises** `ValueError` where there is none, or where a row of it has cells too many or too few.
    """
    rows = filled_up(rows)
    layout = find_layout(rows)
    block = rows[layout.first : layout.end]
    check_widths(block, len(layout.numeric), place, layout.first)
    names, units = headings(rows[: layout.first], len(layout.numeric))
    samples = list(zip(*block, strict=True))
    columns = [
        Column(name, cells_of(list(cells)), unit)
        for name, unit, cells in zip(names, units, samples, strict=True)
        if name or not is_empty(list(cells))
    ]
    columns = [named(column, number) for number, column in enumerate(columns, 1)]
    where = Place(place.word, place.first + layout.first)
    odd = [
        f"{where(row)}, column {printable(name) or at} holds {samples[at - 1][row]!r:.40}, where "
        "the other lines hold numbers. Is the line damaged?"
        for at, (name, row) in enumerate(zip(names, odd_rows(samples), strict=True), 1)
        if row is not None
    ]
    return Sheet(
        tuple(columns),
        where,
        rate=rate_above(rows[: layout.first]),
        notes=(*odd, *remains(rows, layout, place)),
    )


def rate_above(above: list[Row]) -> float | None:
    """Of frames that are numbered, what stands below the title, as Vicon and Nexus write it [Hz]:
    a number by itself.
    """
    alone = [[cell for cell in row if not is_missing(cell)] for row in above[:2]]
    match alone:
        case [[str()], [float(rate)]] if rate > 0 and any({*row} >= FRAMES for row in above):
            return rate
    return None


def filled_up(rows: list[Row]) -> list[Row]:
    """With an empty cell at the end of those rows that stop before a last column of remarks, as
    LabVIEW leaves it out of rows without one, or before a separator at the end of the names.
    """
    header = next((at for at, row in enumerate(rows) if ends_in_remarks(row)), len(rows))
    return [
        [*row, np.nan] if at > header and len(row) == len(rows[header]) - 1 else row
        for at, row in enumerate(rows)
    ]


def ends_in_remarks(row: Row) -> bool:
    """Are these names, the last of which stands above no numbers?"""
    *names, last = row or [np.nan]
    idle = is_missing(last) or (isinstance(last, str) and plain(last) in REMARKS)
    return idle and len(names) > 1 and all(isinstance(name, str) for name in names)


def odd_rows(samples: list[tuple[Cell, ...]]) -> list[int | None]:
    """Of every column that is half of numbers the first row that holds words, if there is one."""
    words = [[row for row, cell in enumerate(cells) if isinstance(cell, str)] for cells in samples]
    numbers = [sum(map(is_number, cells)) for cells in samples]
    return [
        rows[0] if 0 < len(rows) <= count else None
        for rows, count in zip(words, numbers, strict=True)
    ]


def find_layout(rows: list[Row]) -> Layout:
    """The samples are what looks like the rows in the middle."""
    full = [row for row in rows if not is_empty(row)]
    middle = full[max(0, len(full) // 2 - PROBED) : len(full) // 2 + PROBED]
    widths = Counter(len(row) for row in middle if any(map(is_number, row)))
    if not widths:
        raise ValueError(NO_TABLE)
    width = widths.most_common(1)[0][0]
    alike = [row for row in middle if len(row) == width]
    numeric = tuple(
        2 * sum(map(is_number, cells)) > sum(not is_missing(cell) for cell in cells)
        for cells in zip(*alike, strict=True)
    )
    first = next((at for at, row in enumerate(rows) if is_sample(row, numeric)), None)
    if first is None:
        raise ValueError(NO_TABLE)
    end = next((at for at in range(first, len(rows)) if is_empty(rows[at])), len(rows))
    return Layout(first, end, numeric)


def is_sample(row: Row, numeric: tuple[bool, ...]) -> bool:
    """Numbers where the others have numbers, or nothing, but not nothing throughout."""
    return (
        len(row) == len(numeric)
        and any(map(is_number, row))
        and all(
            isinstance(cell, float) for cell, number in zip(row, numeric, strict=True) if number
        )
    )


def check_widths(block: list[Row], width: int, place: Place, first: int) -> None:
    for at, row in enumerate(block):
        if len(row) != width:
            cut = at == len(block) - 1 and len(row) < width
            why = "Is a cell missing, or are there decimal commas?"
            raise ValueError(
                f"{place(first + at)} has {counted(len(row), 'cell')}, but the samples above have "
                f"{width}. {'It is the last one: is the end of the file lost?' if cut else why}"
            )


def headings(above: list[Row], width: int) -> tuple[list[str], list[str]]:
    """Names and units of the columns; no names where nothing stands above the samples."""
    lines = [texts(row) for row in above if not is_empty(row)]
    units = [""] * width
    if len(lines) > 1 and len(lines[-1]) == width and are_units(lines[-1]):
        units = [each.strip("[]() ") for each in lines.pop()]
    if not lines or (width > 2 and len([*filter(None, lines[-1])]) == 1):  # a title is no header
        return [""] * width, units
    names = lines[-1]
    if len(names) == width - 1:  # R writes no name above its numbers of rows
        names = ["row", *names]
    if len(names) != width:
        raise ValueError(
            f"the samples have {width} cells, but {len(names)} names stand above them: "
            f"{listed(names)}. Is a name missing, or are there decimal commas between commas?"
        )
    return grouped(lines[-2], names) if len(lines) > 1 else names, units


def texts(row: Row) -> list[str]:
    """The cells as words, without a comment's mark."""
    words = ["" if is_missing(cell) else str(cell).strip() for cell in row]
    if words and words[0].startswith(COMMENT):
        words[0] = words[0].lstrip("#% ")
        return words if words[0] else words[1:]
    return words


def are_units(words: list[str]) -> bool:
    known = [is_unit(word) or plain(word) in ("", "-", "1") for word in words]
    return all(known) and any(is_unit(word) for word in words)


def grouped(over: list[str], names: list[str]) -> list[str]:
    """Names that say too little, each behind that of its group: X, Y, Z below LKneeAngles."""
    padded = (over + [""] * len(names))[: len(names)]
    groups = list(accumulate(padded, lambda last, this: this or last))
    short = {name for name, count in Counter(names).items() if count > 1} | {*AXES}
    return [
        f"{group}.{name}" if name in short and name and group else name
        for group, name in zip(groups, names, strict=True)
    ]


def cells_of(cells: list[Cell]):
    """Numbers where all are; else what the cells say."""
    if all(isinstance(cell, float) for cell in cells):
        return np.array(cells, dtype=np.float64)
    return tuple("" if is_missing(cell) else as_text(cell) for cell in cells)


def as_text(cell: Cell) -> str:
    """As it was written, a number as short as it can be."""
    return cell if isinstance(cell, str) else f"{cell:.15g}"


def named(column: Column, number: int) -> Column:
    """With a name on one line, a number where the file has none, and the unit taken off it."""
    name = printable(column.name) or str(number)
    return Column(name, column.cells, column.unit or parted(name)[1])


def remains(rows: list[Row], layout: Layout, place: Place) -> tuple[str, ...]:
    """What lies below the samples, for their owner to know."""
    if all(map(is_empty, rows[layout.end :])):
        return ()
    return (f"the samples end at the empty {place(layout.end)}; what follows it is left out.",)
