"""Excel's .xlsx, by openpyxl: of its sheets, the first that holds samples."""

from dataclasses import replace
from datetime import date, datetime, time, timedelta
from pathlib import Path
from typing import Any

from exoid.recordings.tables.dialect import value_of
from exoid.recordings.tables.layout import Cell, Row, is_number, sheet_of_rows
from exoid.recordings.tables.sheet import Place, Sheet, printable

DECIMALS = (".", ",")  # of numbers that are kept as text


def read_excel(path: Path) -> Sheet:
    """The rows of the first sheet with two rows that hold numbers.

    **Raises** `ValueError` where there is none.
    """
    import openpyxl

    book = openpyxl.load_workbook(path, read_only=True, data_only=True)
    try:
        names = [sheet.title for sheet in book.worksheets]
        for sheet in book.worksheets:
            rows = [[*map(cell_of, cells)] for cells in sheet.iter_rows(values_only=True)]
            if sum(any(map(is_number, row)) for row in rows) > 1:
                found = sheet_of_rows(squared(rows), Place("row", 1))
                said = f"sheet {printable(sheet.title)} of {len(names)} is read."
                return found if len(names) == 1 else replace(found, notes=(*found.notes, said))
    finally:
        book.close()
    raise ValueError(
        f"holds no table of numbers in its sheets: {', '.join(map(printable, names))}."
    )


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
