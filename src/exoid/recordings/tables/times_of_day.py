"""Times of day and dates, as seconds since the first of them."""

import re

import numpy as np

GERMAN = re.compile(r"^(\d{1,2})\.(\d{1,2})\.(\d{4})[ T]+")
OF_DAY = re.compile(r"^\d{1,2}:\d{2}(:\d{2}([.,]\d+)?)?$")


def seconds(cells: tuple[str, ...]) -> np.ndarray | None:
    """Seconds since the first date or time of day; None where they are neither.

    2026-11-21 10:00:00.010, 21.11.2026 10:00:00,010 or 10:00:00.010; an empty cell is NaN.
    """
    try:
        moments = np.array([moment(cell) for cell in cells], dtype="datetime64[us]")
    except ValueError:
        return None
    known = ~np.isnat(moments)
    if not known.any():
        return None
    passed = (moments - moments[known][0]) / np.timedelta64(1, "s")
    return np.where(known, passed, np.nan)


def is_time(cell: str) -> bool:
    return ":" in cell and seconds((cell,)) is not None


def moment(cell: str) -> str:
    cell = cell.strip().replace(",", ".").removesuffix("Z")
    if not cell:
        return "NaT"
    if OF_DAY.match(cell):
        cell = f"2000-01-01 {cell.zfill(len(cell) + (cell.index(':') == 1))}"
    elif found := GERMAN.match(cell):
        day, month, year = found.groups()
        cell = f"{year}-{month:0>2}-{day:0>2} {cell[found.end() :]}"
    elif ":" not in cell:
        raise ValueError("neither a date nor a time of day")
    return cell.replace(" ", "T", 1)
