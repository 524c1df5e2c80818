"""A small table with words in it, whatever its format: what its cells say, as texts."""

import csv
import json
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import zip_longest
from pathlib import Path

import numpy as np

from exoid.files.extras import require
from exoid.files.foreign import Arrays, read_apart
from exoid.files.text_file import misquoted
from exoid.recordings.formats.delimited import legible
from exoid.recordings.formats.packed import unpacked
from exoid.recordings.formats.parquet import columns

DELIMITERS = "\t;,"  # the first of them that the header holds parts its cells
AGAIN = "Save it again."


@dataclass(frozen=True)
class Row:
    """The cells of a row by the names of their columns, and where it stands."""

    cells: dict[str, str]
    place: str


def rows_of(path: Path) -> list[Row]:
    """The rows of a .csv, .tsv, .parquet or .xlsx; those without any cell are left out.

    **Raises** `ValueError` in one line, without the name of the file.
    """
    reader = {".parquet": of_parquet, ".xlsx": of_excel}.get(path.suffix.lower(), of_text)
    table = list(reader(path))
    if not table:
        raise ValueError("is empty. Its first line names the columns: id, body_mass_kg, height_m.")
    (_, names), *rows = table
    names = [name.strip() for name in names]
    if twice := [name for name in names if name and names.count(name) > 1]:
        raise ValueError(f"column {twice[0]} is there twice. Delete or rename one.")
    return [named(names, *row) for row in rows if any(cell.strip() for cell in row[1])]


def named(names: list[str], place: str, cells: list[str]) -> Row:
    if any(cell.strip() for cell in cells[len(names) :]):
        raise ValueError(
            f"{place} has {len(cells)} cells, but the header names {len(names)} columns. Is there "
            "a comma in a cell? Put the cell in quotes."
        )
    pairs = zip_longest(names, cells[: len(names)], fillvalue="")
    return Row({name: cell.strip() for name, cell in pairs if name}, place)


Numbered = Iterator[tuple[str, list[str]]]  # where a row stands, and its cells


def of_text(path: Path) -> Numbered:
    text = legible(path)
    first = text.partition("\n")[0]
    delimiter = next((each for each in DELIMITERS if each in first), ",")
    reader = csv.reader(text.splitlines(keepends=True), delimiter=delimiter, strict=True)
    try:
        for row in reader:
            yield f"line {reader.line_num}", row
    except csv.Error as fault:
        raise ValueError(f"line {reader.line_num}: {misquoted(fault)}") from fault


def of_parquet(path: Path) -> Numbered:
    require("pyarrow", "a Parquet file is read")
    found = unpacked(read_apart(columns, path, AGAIN, library="pyarrow.parquet"))
    yield "its names", [*found]
    for number, cells in enumerate(zip(*(each.tolist() for each in found.values()), strict=True)):
        yield f"row {number}", [*map(word_of, cells)]


def of_excel(path: Path) -> Numbered:
    require("openpyxl", "an Excel workbook is read")
    book = read_apart(first_sheet, path, AGAIN, library="openpyxl")
    for number, cells in enumerate(json.loads(book["rows"].tobytes()), 1):
        yield f"row {number}", [*map(word_of, cells)]


def first_sheet(path: Path) -> Arrays:
    """The cells of the first sheet, as JSON; in a process of its own."""
    import openpyxl

    sheet = openpyxl.load_workbook(path, read_only=True, data_only=True).worksheets[0]
    sheet.reset_dimensions()  # a size that the file announces would cut it
    rows = [*sheet.iter_rows(values_only=True)]
    return {"rows": np.frombuffer(json.dumps(rows, default=str).encode(), np.uint8)}


def word_of(cell: object) -> str:
    """A whole number without its point: an id is 7, not 7.0."""
    if cell is None or cell != cell:
        return ""
    return str(int(cell)) if isinstance(cell, float) and cell.is_integer() else str(cell)
