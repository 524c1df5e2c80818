"""The cells of a table without what loggers are known to do to them, said.

What is one way only is mended; whatever else is left as it is, for the recording to refuse.
"""

import numpy as np

from exoid.files.text_file import Notes
from exoid.recordings.measured.samples import Samples
from exoid.recordings.tables.mending.clock_overflow import going_on
from exoid.recordings.tables.mending.doubled_rows import Cells, Columns, doubled
from exoid.recordings.tables.mending.full_turns import TURN, turns_left_out
from exoid.recordings.tables.mending.missing_word import missing_word, named
from exoid.recordings.tables.mending.rounded_times import unrounded
from exoid.recordings.tables.mending.unit_change import unit_change

ANGLES = ("raw_angle_rad", "angle_rad")
RATES = ("raw_velocity_rad_s", "velocity_rad_s")


def without_doubled(columns: Columns) -> tuple[tuple[int, ...] | None, Columns, Notes]:
    """Which rows are left, None for all, and their cells."""
    again = doubled(columns)
    if not again.any():
        return None, columns, ()
    rows = tuple(np.flatnonzero(~again).tolist())
    kept: dict[str, Cells] = {
        name: cells[~again] if isinstance(cells, np.ndarray) else tuple(cells[row] for row in rows)
        for name, cells in columns.items()
    }
    number, verb = ("1 row", "is") if again.sum() == 1 else (f"{again.sum()} rows", "are")
    note = f"{number} {verb} there twice, with the same time and values: taken once."
    return rows, kept, (note,)


def mended(columns: Columns, starts: np.ndarray) -> tuple[Columns, Notes]:
    """The columns of segments that begin at these rows, with even times in place of rounded ones,
    empty cells in place of words for them, and whole turns.
    """
    parts = [slice(*rows) for rows in zip(starts, [*starts[1:], None], strict=True)]
    found, notes = dict(columns), []
    for change in (with_time_going_on, with_even_times, without_words, with_turns, in_one_unit):
        more, said = change(found, parts)
        found |= more
        notes += said
    return found, tuple(notes)


def with_time_going_on(columns: Columns, parts: list[slice]) -> tuple[Columns, Notes]:
    """The times, of segments in which the logger's counter was full."""
    time = np.array(columns["time_s"], dtype=float)
    full = {}
    for part in parts:
        if (found := going_on(time[part])) is not None:
            time[part], counted = found
            full[counted] = None
    if not full:
        return {}, ()
    ticks = " or ".join(full)
    note = f"time_s begins again where a counter of 2^32 {ticks} is full: it goes on there."
    return {"time_s": time}, (note,)


def with_even_times(columns: Columns, parts: list[slice]) -> tuple[Columns, Notes]:
    """The times, of segments that were taken evenly and stamped with too few digits."""
    time = np.array(columns["time_s"], dtype=float)
    steps = []
    for part in parts:
        if (even := unrounded(time[part])) is not None:
            time[part] = even
            steps.append(1e3 * float(even[1] - even[0]))
    if not steps:
        return {}, ()
    note = (
        "times are rounded, so that samples have the same: they are taken for evenly apart, by "
        f"{np.mean(steps):.4g} ms. Write times with more digits."
    )
    return {"time_s": time}, (note,)


def without_words(columns: Columns, parts: list[slice]) -> tuple[Columns, Notes]:
    """The channels in which a number stands for none, with empty cells there."""
    found: dict[str, Cells] = {}
    notes = []
    for name in (*ANGLES, *RATES):
        samples = np.asarray(columns.get(name, np.empty(0)), dtype=float)
        word = None if np.isnan(samples).all() else missing_word(samples)
        if word is None:
            continue
        found[name] = np.where(samples == word, np.nan, samples)
        notes.append(
            f"{np.sum(samples == word)} cells of {name} say {named(word)}, far from all "
            "others, as where none was measured: they are left out. Leave such cells "
            "empty."
        )
    return found, tuple(notes)


def in_one_unit(columns: Columns, parts: list[slice]) -> tuple[Columns, Notes]:
    """Nothing: which unit is the right one, the file does not say."""
    notes = []
    for name in ANGLES:
        if name not in columns:
            continue
        time, angle = (np.asarray(columns[each], dtype=float) for each in ("time_s", name))
        changes = [unit_change(time[part], angle[part]) for part in parts]
        notes += [
            f"from {at:.2f} s on the angle is 57.3 times as large or small as before, as where "
            "degrees become radians: write all of it in one unit."
            for at in changes
            if at is not None
        ]
    return {}, tuple(notes)


def with_turns(columns: Columns, parts: list[slice]) -> tuple[Columns, Notes]:
    """The angles that jump by whole turns, going on there."""
    found: dict[str, Cells] = {}
    notes = []
    for name in ANGLES:
        if name in columns and (angle := unwrapped(columns, name, parts)) is not None:
            found[name] = angle
            notes.append(
                "the angle jumps by a turn now and then, as where an encoder passes 0 or 360 deg: "
                "whole turns are added, so that it goes on."
            )
    return found, tuple(notes)


def unwrapped(columns: Columns, name: str, parts: list[slice]) -> Samples | None:
    """An angle with the turns that it lacks, the middle of every segment within half a turn of
    that of the first, and this within half a turn of 0; None where it lacks none.
    """
    time, angle = (np.asarray(columns[each], dtype=float) for each in ("time_s", name))
    lacks = [turns_left_out(time[part], angle[part]) for part in parts]
    if all(each is None for each in lacks):
        return None
    angle, middle = angle.copy(), 0.0
    for part, each in zip(parts, lacks, strict=True):
        angle[part] += 0.0 if each is None else each
        if not np.isnan(angle[part]).all():
            angle[part] -= TURN * np.round((np.nanmedian(angle[part]) - middle) / TURN)
            middle = float(np.nanmedian(angle[part]))
    return angle
