"""Times of day and dates, as seconds since the first of them."""

import re
from dataclasses import dataclass

import numpy as np

from exoid.recordings.tables.sheet import Column, Place

GERMAN = re.compile(r"^(\d{1,2})\.(\d{1,2})\.(\d{4})[ T]+")
OF_DAY = re.compile(r"^\d{1,2}:\d{2}(:\d{2}([.,]\d+)?)?$")
ZONE = re.compile(r"(?<=\d)\s*(Z|UTC|[+-]\d{2}(?::?\d{2})?)$")
ZONED = re.compile(r"[-+ZU]")  # what a tail with a zone holds, and the end of no other time
TAIL = 7  # characters
UNIT = "s since the first"
DAY = np.timedelta64(1, "D").astype("timedelta64[s]")  # back by more than half of it is midnight
REPAIR = "Correct it, or leave the cell empty."


@dataclass(frozen=True, eq=False)
class Clock:
    """The seconds of a column of times, NaN where a cell is empty, and what they are, in words."""

    seconds: np.ndarray
    unit: str


def read_clock(column: Column, place: Place) -> Clock | None:
    """Seconds since the first date or time of day; None where the first cell is neither.

    2026-11-21 10:00:00.010, 21.11.2026 10:00:00,010 or 10:00:00.010, each as it is or with a time
    zone (Z, +01:00). Times of day run on over midnight.

    **Raises** `ValueError` for a cell that is no time, or is not written as the first: with a zone
    or a date where that has none, or without.
    """
    cells = [cell.strip() for cell in column.texts]
    filled = [row for row, cell in enumerate(cells) if cell]
    if not filled or not is_time(cells[filled[0]]):
        return None
    first = cells[filled[0]]
    zones = [zone_of(cell) for cell in cells]
    bare = [cell.removesuffix(zone) for cell, zone in zip(cells, zones, strict=True)]
    moments = np.array([], dtype="datetime64[us]")
    try:
        moments = np.array([moment(cell) for cell in bare], dtype="datetime64[us]")
        odd = of_another_kind(bare, zones, filled)
    except ValueError:  # which does not say where
        odd = next(row for row in filled if not is_time(bare[row]))
    if odd is not None:
        problem = unlike(cells[odd], first, place(filled[0]))
        raise ValueError(f"{place(odd)}, column {column.name}: {cells[odd][:40]!r} {problem}")
    moments -= np.array([offset(zone) for zone in zones], dtype="timedelta64[s]")
    if is_dated(bare[filled[0]]):
        return since_first(moments, UNIT)
    return over_midnight(moments, place)


def of_another_kind(bare: list[str], zones: list[str], filled: list[int]) -> int | None:
    """The first row that is not written as the first; None where all are alike."""
    zoned, dated = zones[filled[0]] != "", is_dated(bare[filled[0]])
    rows = ((row, zones[row] != "", is_dated(bare[row])) for row in filled)
    return next((row for row, *kind in rows if kind != [zoned, dated]), None)


def over_midnight(moments: np.ndarray, place: Place) -> Clock:
    """Times of day, which begin anew where a day does."""
    known = np.flatnonzero(~np.isnat(moments))
    rows = known[1:][np.diff(moments[known]) < -DAY / 2]
    if not rows.size:
        return since_first(moments, UNIT)
    days = np.searchsorted(rows, np.arange(moments.size), side="right")
    said = ", ".join(place(int(row)) for row in rows[:3])
    return since_first(moments + DAY * days, f"{UNIT}, over midnight at {said}")


def since_first(moments: np.ndarray, unit: str) -> Clock:
    first = moments[~np.isnat(moments)][0]
    return Clock((moments - first) / np.timedelta64(1, "s"), unit)


def unlike(cell: str, first: str, there: str) -> str:
    """What is wrong with a time beside the first, which stands `there`."""
    if not is_time(cell):
        return f"is no time, but {there} holds {first[:40]!r}. {REPAIR}"
    zoned = (zone_of(cell) != "", zone_of(first) != "")
    what = "time zone" if zoned[0] != zoned[1] else "date"
    has = zoned[0] if zoned[0] != zoned[1] else is_dated(cell.removesuffix(zone_of(cell)))
    told, other = ("a", "none") if has else ("no", "one")
    return (
        f"tells {told} {what}, but {there} tells {other}, so that nobody knows how far they are "
        f"apart. Write all times with a {what}, or all without."
    )


def is_time(cell: str) -> bool:
    cell = cell.strip()
    try:
        return ":" in cell and not np.isnat(
            np.datetime64(moment(cell.removesuffix(zone_of(cell))), "us")
        )
    except ValueError:
        return False


def zone_of(cell: str) -> str:
    """As it stands at the end; empty where there is none."""
    found = ZONE.search(cell) if ":" in cell and ZONED.search(cell[-TAIL:]) else None
    return found[0] if found else ""


def is_dated(bare: str) -> bool:
    return OF_DAY.match(bare) is None


def offset(zone: str) -> int:
    """How far it is ahead of UTC [s]."""
    zone = zone.strip().replace(":", "")
    if zone in ("", "Z", "UTC"):
        return 0
    ahead = 3600 * int(zone[1:3]) + 60 * int(zone[3:5] or 0)
    return -ahead if zone[0] == "-" else ahead


def moment(bare: str) -> str:
    """As NumPy reads a time without its zone."""
    bare = bare.replace(",", ".")
    if not bare:
        return "NaT"
    if OF_DAY.match(bare):
        bare = f"2000-01-01 {bare.zfill(len(bare) + (bare.index(':') == 1))}"
    elif found := GERMAN.match(bare):
        day, month, year = found.groups()
        bare = f"{year}-{month:0>2}-{day:0>2} {bare[found.end() :]}"
    elif ":" not in bare:
        raise ValueError("neither a date nor a time of day")
    return bare.replace(" ", "T", 1)
