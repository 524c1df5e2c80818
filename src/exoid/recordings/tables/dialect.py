"""How a text writes its table: what separates cells, and what stands before the decimals."""

import csv
import re
from dataclasses import dataclass
from functools import partial

from exoid.files.text_file import misquoted
from exoid.recordings.tables.layout import NO_TABLE, Cell, Row
from exoid.recordings.tables.times_of_day import is_time

MISSING = {"", "nan", "na", "n/a", "#n/a", "#nv", "null", "none", "-", "--"}
NUMBERS = {
    ".": re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?", re.ASCII),
    ",": re.compile(
        r"[+-]?(?:\d+(?:,\d+)?|,\d+|\d{1,3}(?:\.\d{3})+,\d+)(?:[eE][+-]?\d+)?", re.ASCII
    ),  # 1.234,5 as well
}
PROBED = 50  # lines in the middle, by which the ways of writing are compared
BLANK = " "  # stands for any number of blanks
DOUBT = 0.9  # of blanks, which stand within titles and beside other separators as well
LEAST = 0.4  # share of the cells that are numbers, below which it is no table
SHORTEST = 3  # lines: titles, and two samples
DECLARED = re.compile(r"^sep=(.)$", re.IGNORECASE)  # Excel's own first line


@dataclass(frozen=True)
class Dialect:
    """The separator of cells and the decimal mark."""

    separator: str
    decimal: str


DIALECTS = [  # the first of those that read as many numbers is taken
    Dialect(",", "."),
    Dialect(";", ","),
    Dialect(";", "."),
    Dialect("\t", "."),
    Dialect("\t", ","),
    Dialect("|", "."),
    Dialect("|", ","),
    Dialect(BLANK, "."),
    Dialect(BLANK, ","),
    Dialect(",", ","),  # every number in quotes
]


def rows_of(text: str) -> list[Row]:
    """Every line of a text as its cells; an empty line is an empty row.

    **Raises** `ValueError` where no way of writing makes a table of it.
    """
    lines = text.rstrip("\n").split("\n")
    if DECLARED.match(lines[0]):
        lines[0] = ""
    return rows_in(lines, sniffed(lines))


def rows_in(lines: list[str], dialect: Dialect) -> list[Row]:
    """The cells of each line, in a dialect that is known."""
    value = partial(value_of, decimal=dialect.decimal)
    try:
        return [[value(cell) for cell in cells] for cells in split(lines, dialect.separator)]
    except csv.Error as error:
        raise ValueError(misquoted(error)) from error


def sniffed(lines: list[str]) -> Dialect:
    """The dialect in which most cells of the middle lines are numbers."""
    full, middle = probed(lines)
    alone = single(full[: 2 * PROBED])
    if alone is not None:
        return alone
    shares = {dialect: share(middle, dialect) for dialect in DIALECTS}
    best = max(DIALECTS, key=shares.__getitem__)
    if shares[best] < LEAST:
        raise ValueError(NO_TABLE)
    return best


def holds_table(lines: list[str]) -> bool:
    """Would some dialect do? Sooner told than which of them does best."""
    full, middle = probed(lines)
    if len(full) < SHORTEST:
        return False
    some = any(share(middle, dialect) >= LEAST for dialect in DIALECTS)
    return some or single(full[: 2 * PROBED]) is not None


def probed(lines: list[str]) -> tuple[list[str], list[str]]:
    """The lines that are not empty, and those in the middle of them."""
    full = [line for line in lines if line.strip()]
    begin = max(0, len(full) // 2 - PROBED // 2)
    return full, full[begin : begin + PROBED]


def single(lines: list[str]) -> Dialect | None:
    """The dialect of one column alone: titles without a comma, then a number in every line."""
    for decimal, number in NUMBERS.items():
        alone = [number.fullmatch(line.strip()) is not None for line in lines]
        first = alone.index(True) if any(alone) else 0
        if first and all(alone[first:]) and not any("," in line for line in lines[:first]):
            return Dialect(";", decimal)
    return None


def share(lines: list[str], dialect: Dialect) -> float:
    """The share of numbers and times among the cells, in lines of the width that most have."""
    try:
        rows = list(split(lines, dialect.separator))
    except csv.Error:
        return 0.0
    widths = [len(row) for row in rows if len(row) > 1]
    if not widths:
        return 0.0
    width = max(set(widths), key=lambda each: (widths.count(each), each))
    cells = [cell.strip() for row in rows if len(row) == width for cell in row]
    number = NUMBERS[dialect.decimal]
    numbers = sum(bool(number.fullmatch(cell)) or is_time(cell) for cell in cells)
    told = sum(cell.lower() not in MISSING for cell in cells)
    alike = widths.count(width) / len(rows)
    return numbers / max(told, 1) * alike * (DOUBT if dialect.separator == BLANK else 1.0)


def split(lines: list[str], separator: str):
    """The cells of each line; a line is a row, whatever its quotes say."""
    if separator == BLANK:
        return [line.split() for line in lines]
    return [
        next(csv.reader([line], delimiter=separator, skipinitialspace=True), [])
        if line.strip()
        else []
        for line in lines
    ]


def value_of(cell: str, decimal: str) -> Cell:
    """A number, NaN where there is none, or the words of a cell."""
    cell = cell.strip()
    if NUMBERS[decimal].fullmatch(cell):
        return float(cell.replace(".", "").replace(",", ".") if decimal == "," else cell)
    return float("nan") if cell.lower() in MISSING else cell
