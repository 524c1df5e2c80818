"""Excel's .xlsx, by openpyxl: of its sheets, the first that holds samples."""

import json
import re
from dataclasses import replace
from datetime import date, datetime, time, timedelta
from itertools import pairwise
from pathlib import Path
from typing import Any
from zipfile import ZipFile

import numpy as np

from exoid.files.foreign import Arrays, read_apart
from exoid.recordings.tables.dialect import value_of
from exoid.recordings.tables.layout import Cell, Row, is_number, sheet_of_rows
from exoid.recordings.tables.sheet import Place, Sheet, printable

KIND = re.compile(rb"""<(?:\w+:)?c\b[^>]*?\st=["']([^"']*)["']""")
ROW = re.compile(rb"""<(?:\w+:)?row\b[^>]*?\sr=["'](\d{1,9})["']""")
KINDS = {b"n", b"s", b"str", b"inlineStr", b"b", b"e", b"d"}
DECIMALS = (".", ",")  # of numbers that are kept as text


def read_excel(path: Path) -> Sheet:
    """The rows of the first sheet with two rows that hold numbers.

    **Raises** `ValueError` where there is none.
    """
    kept = read_apart(content, path, "Export it again.", library="openpyxl")
    book = json.loads(kept["book"].tobytes())
    names, rows = [printable(name) for name in book["names"]], book["rows"]
    if not rows:
        raise ValueError(f"holds no table of numbers in its sheets: {', '.join(names)}.")
    found = sheet_of_rows(squared(rows), Place("row", 1))
    said = f"sheet {names[book['taken']]} of {len(names)} is read."
    return found if len(names) == 1 else replace(found, notes=(*found.notes, said))


def content(path: Path) -> Arrays:
    """The names of the sheets, which of them is taken, and its rows, as JSON; in a process of its
    own.
    """
    import openpyxl

    check_sheets(path)
    book = openpyxl.load_workbook(path, read_only=True, data_only=True)
    names = [sheet.title for sheet in book.worksheets]
    found: dict[str, Any] = {"names": names, "taken": None, "rows": []}
    for taken, sheet in enumerate(book.worksheets):
        sheet.reset_dimensions()  # a size that the file announces would cut it
        rows = [[*map(cell_of, cells)] for cells in sheet.iter_rows(values_only=True)]
        if sum(any(map(is_number, row)) for row in rows) > 1:
            found |= {"taken": taken, "rows": rows}
            break
    return {"book": np.frombuffer(json.dumps(found).encode(), np.uint8)}


def check_sheets(path: Path) -> None:
    """Refuse what no program writes and openpyxl leaves out: cells of other kinds, a row twice."""
    with ZipFile(path) as archive:
        for name in archive.namelist():
            if name.startswith("xl/worksheets/") and name.endswith(".xml"):
                text = archive.read(name)
                odd = {*KIND.findall(text)} - KINDS
                if odd:
                    raise ValueError(f"a cell has the unknown kind {min(odd)[:20]!r}")
                if any(next_one <= one for one, next_one in pairwise(map(int, ROW.findall(text)))):
                    raise ValueError("its rows are not in their order")


def cell_of(cell: Any) -> Cell:
    """A number, NaN where there is none, or words; a date in the one way that sorts."""
    if cell is None:
        return float("nan")
    if isinstance(cell, int | float):
        return float(cell)
    if isinstance(cell, timedelta):
        return cell.total_seconds()
    if isinstance(cell, datetime | date | time):
        return cell.isoformat()
    values = [value_of(str(cell), decimal) for decimal in DECIMALS]
    return next((value for value in values if isinstance(value, float)), values[0])


def squared(rows: list[Row]) -> list[Row]:
    """All rows as wide as the widest: openpyxl cuts them where nothing follows."""
    width = max(map(len, rows))
    return [row + [float("nan")] * (width - len(row)) for row in rows]
