"""From columns under anybody's names to exoid's own: in SI, and with what was understood in words.

In this order: what a map of columns says, exoid's own names, the names that others use.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np

from exoid.files.text_file import Notes, near
from exoid.recordings.columns import ANGLES, NUMERIC, SEGMENT, TARGETS, UNITS, Target
from exoid.recordings.tables.dialect import NUMBERS
from exoid.recordings.tables.names import recognised
from exoid.recordings.tables.sheet import Cells, Column, Place, Sheet, listed
from exoid.recordings.tables.times_of_day import read_clock
from exoid.recordings.tables.units import plain, size_of

LARGEST_RADIANS = {"rad": 7.0, "rad/s": 35.0}  # beyond it a number without a unit is in degrees
DEGREE = np.pi / 180
GYRO_AMONG = "A gyro among them is named:"
MISSPELT = 0.9  # two letters of a long name changed places


@dataclass(frozen=True)
class Match:
    """A column of the file and what it becomes; size None: the unit is to be found."""

    column: Column
    target: str
    size: float | None
    guessed: bool = False  # by its name; what the user or exoid's own name says is no guess


@dataclass(frozen=True, eq=False)
class Named:
    """Exoid's own columns, where their samples stand in the file, and what they are there."""

    columns: dict[str, Cells]
    place: Place
    sources: dict[str, str]  # own column: what it was, in words, where it was called otherwise
    notes: Notes


def assemble(
    sheet: Sheet,
    chosen: Mapping[str, str],
    rate: float | None = None,
    *,
    measured: bool = False,
) -> Named:
    """The columns that a recording is made of.

    `chosen` maps targets to names in the file; `rate` [Hz] is what the sidecar says, for a file
    without a time. Where it says that a torque was `measured`, the only column in N m is that one.

    **Raises** `ValueError` where there is no time or no angle, or where it could be several.
    """
    matches = matched(sheet, chosen)
    matches += torque_by_unit(sheet, matches) if measured else []
    taken = {match.column.name for match in matches}
    columns, sources, units = {}, {}, []
    for match in matches:
        if match.target in columns:
            raise ValueError(f"two columns become {match.target}. Name one of them.")
        columns[match.target], unit = converted(match, sheet.place)
        name = match.column.name
        if name != match.target:
            sources[match.target] = f"{name}: read {f'in {unit}' if unit else 'in its own unit'}"
        if match.guessed or unit:
            units.append(f"{name} as {match.target}{f' (in {unit})' if unit else ''}")
    notes = list(sheet.notes)
    if "time_s" not in columns:
        columns["time_s"] = counted(sheet, rate)
        notes.append(f"it has no time: samples are taken {rate or sheet.rate:g} times a second.")
    check_angle(columns, sheet, taken)
    notes += [f"read {'; '.join(units)}."] if units else []
    others = [column for column in sheet.columns if column.name not in taken]
    unknown = [column.name for column in others]
    if "time_s" in sheet.names:
        notes += kept(unknown)
        columns |= {column.name: column.texts for column in others}
    else:
        notes += left_out(sheet, others)
    return Named(without_empty(columns, notes), sheet.place, sources, tuple(notes))


def matched(sheet: Sheet, chosen: Mapping[str, str]) -> list[Match]:
    """What becomes what, each target once."""
    found = [
        Match(picked(sheet, target, name), *unpacked(target)) for target, name in chosen.items()
    ]
    taken = {match.column.name for match in found}
    for column in sheet.columns:
        if is_own(column.name) and column.name not in taken:
            found.append(Match(column, *unpacked(column.name)))
    taken = {match.target for match in found}
    rest = tuple(
        column for column in sheet.columns if all(match.column is not column for match in found)
    )
    wanted = {
        "time": "time_s",
        "segment": SEGMENT,
        "angle": "raw_angle_rad",
        "gyro": "raw_velocity_rad_s",
        "torque": "torque_nm",
    }
    for quantity, target in wanted.items():
        if target in taken or (quantity == "angle" and taken & {*ANGLES}):
            continue
        likely = recognised(rest, quantity)
        if quantity == "time" and not likely:
            likely = [column for column in rest if column.name == sheet.time]
        column = only(sheet, quantity, likely)
        if column is not None:
            found.append(Match(column, target, 1.0 if target == SEGMENT else None, guessed=True))
    return found


def torque_by_unit(sheet: Sheet, matches: list[Match]) -> list[Match]:
    """The measured torque where no name tells it: the only column in N m that is nothing else."""
    taken = {match.column.name for match in matches}
    likely = [
        column
        for column in sheet.columns
        if column.name not in taken and size_of(column.unit, UNITS["torque_nm"]) is not None
    ]
    if len(likely) != 1 or any(match.target == "torque_nm" for match in matches):
        return []
    return [Match(likely[0], "torque_nm", None, guessed=True)]


def is_own(name: str) -> bool:
    """Is this a name of exoid's own, which nobody else means otherwise?"""
    return name in TARGETS and (TARGETS[name].size is not None or name.startswith("raw_"))


def unpacked(target: str) -> tuple[str, float | None]:
    known = TARGETS.get(target, Target(target, None))
    return known.column, known.size


def picked(sheet: Sheet, target: str, name: str) -> Column:
    """The column that a map names."""
    if target not in TARGETS:
        raise ValueError(
            f"there is no column {target} to fill.{near(target, TARGETS)} "
            f"It can be {listed(sorted(NUMERIC), 99)}."
        )
    column = sheet.column(name) or sheet.column(name.strip())
    if column is None:
        hint = near(name, sheet.names) if sheet.names else ""
        raise ValueError(
            f"has no column {name!r} for {target}.{hint} It holds: {listed(sheet.names, 40)}."
        )
    return column


def only(sheet: Sheet, quantity: str, columns: list[Column]) -> Column | None:
    """The one column that it can be; None where there is none, or several that are not needed."""
    asked = {"time": "time_s", "angle": "raw_angle_deg"}
    if len(columns) > 1 and quantity in asked:
        names = listed([column.name for column in columns])
        ask = sheet.ask.format(asked[quantity]).replace("...", columns[0].name)
        raise ValueError(f"several columns can be the {quantity}: {names}. Choose one: {ask}.")
    return columns[0] if len(columns) == 1 else None


def converted(match: Match, place: Place) -> tuple[Cells, str]:
    """A column in SI, and its unit in the file in words, where that had to be found."""
    column = match.column
    if match.target == SEGMENT:
        return renumbered(column) if match.guessed else in_numbers(column, place), ""
    if match.target == "time_s" and not column.numeric:
        clock = read_clock(column, place)
        if clock is not None:
            return clock.seconds, clock.unit
    numbers = in_numbers(column, place)
    if match.size is not None:
        return numbers * match.size if match.size != 1.0 else numbers, ""
    size, unit = found_size(match, numbers)
    return numbers * size if size != 1.0 else numbers, unit.replace("grad", "deg")


def in_numbers(column: Column, place: Place) -> np.ndarray:
    if column.numeric:
        return np.asarray(column.cells)
    for row, cell in enumerate(column.cells):
        if cell and not is_float(cell):
            raise ValueError(
                f"{place(row)}, column {column.name}: {cell[:40]!r} is not a number. "
                "Leave the cell empty where a sample is missing."
            )
    return np.array([float(cell) if cell else np.nan for cell in column.cells])


def is_float(cell: str) -> bool:
    """Not what only Python takes for a number, such as 1_000."""
    return NUMBERS["."].fullmatch(cell) is not None


def found_size(match: Match, numbers: np.ndarray) -> tuple[float, str]:
    """The size of the column's unit in SI: as the file says it, else as its numbers do."""
    column, si = match.column, UNITS[match.target]
    if column.unit:
        size = size_of(column.unit, si)
        if size is None:
            raise ValueError(
                f"column {column.name} is in {column.unit}, but {match.target} is in {si}. Name "
                "another, or say its true unit, as raw_angle_deg and raw_velocity_rad_s do."
            )
        return size, si if size == 1.0 else plain(column.unit)
    largest = np.nanmax(np.abs(numbers)) if not np.isnan(numbers).all() else 0.0
    if largest > LARGEST_RADIANS.get(si, np.inf):
        return DEGREE, f"{si.replace('rad', 'deg')} by its size"
    return 1.0, f"{si} by its size" if si in LARGEST_RADIANS else si


def renumbered(column: Column) -> np.ndarray:
    """0, 1, 2, ... for whatever a file calls its trials, in their order."""
    cells = np.asarray(column.cells)
    same = (cells[1:] == cells[:-1]) | ((cells[1:] != cells[1:]) & (cells[:-1] != cells[:-1]))
    return np.concatenate([[0.0], np.cumsum(~same)])


def counted(sheet: Sheet, rate: float | None) -> np.ndarray:
    """Times from the rate, where no column tells them."""
    known = rate or sheet.rate
    if not known:
        raise ValueError(
            f"has no time. It holds: {listed(sheet.names, 40)}. Name it: "
            f"{sheet.ask.format('time_s')}, or give sample_rate_hz in [sensors]."
        )
    return np.arange(len(sheet.columns[0].cells)) / known


def check_angle(columns: Mapping[str, Cells], sheet: Sheet, taken: set[str]) -> None:
    if not any(name in columns for name in ANGLES):
        if gyros(sheet.columns) or any("velocity" in name for name in columns):
            raise ValueError(
                f"has no angle, and a turning rate alone is not enough: it does not tell where "
                f"the leg hangs. It holds: {listed(sheet.names, 40)}. Record the knee's angle "
                f"beside it; an angle among these is named: {sheet.ask.format('raw_angle_deg')}."
            )
        hints = (near(name, NUMERIC, MISSPELT) for name in sheet.names if name not in NUMERIC)
        raise ValueError(
            f"has no angle. It holds: {listed(sheet.names, 40)}.{next(filter(None, hints), '')} "
            f"Name it: {asked_angle(sheet, taken)}."
        )


def asked_angle(sheet: Sheet, taken: set[str]) -> str:
    """How to name the angle: with the only other column where there is one."""
    others = [column for column in sheet.columns if column.name not in taken]
    if len(others) != 1 or '"' in others[0].name:
        return sheet.ask.format("raw_angle_deg")
    (one,) = others
    size = size_of(one.unit, "rad") if one.unit else DEGREE
    target = "raw_angle_rad" if size == 1.0 else "raw_angle_deg"
    return sheet.ask.format(target).replace("...", one.name)


def gyros(columns: Iterable[Column]) -> list[str]:
    """Those that sound like a turning rate, or have its unit."""
    return [
        each.name
        for each in columns
        if "velocity" in each.name.lower()
        or "gyr" in each.name.lower()
        or size_of(each.unit, "rad/s") is not None
    ]


def kept(others: list[str]) -> list[str]:
    return [f"unknown column {name} is kept as text.{near(name, NUMERIC)}" for name in others]


def left_out(sheet: Sheet, others: list[Column]) -> list[str]:
    if not others:
        return []
    ask = sheet.ask.format("raw_velocity_deg_s")
    hint = f" {GYRO_AMONG} {ask}." if gyros(others) else ""
    return [f"not read: {listed([each.name for each in others])}.{hint}"]


def without_empty(columns: dict[str, Cells], notes: list[str]) -> dict[str, Cells]:
    """Channels that hold no number are left out, and said."""
    empty = [
        name
        for name, cells in columns.items()
        if name in NUMERIC - {"time_s", SEGMENT} and np.isnan(np.asarray(cells, float)).all()
    ]
    notes += [f"column {name} holds no number and is left out." for name in empty]
    return {name: cells for name, cells in columns.items() if name not in empty}
