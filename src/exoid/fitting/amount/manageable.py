"""Recordings of any length and number, brought down to what one fit takes; what was left out is
said.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from exoid.fitting.amount.means import averaged
from exoid.fitting.amount.part import Part, apart, parts_of
from exoid.fitting.amount.spread import spread
from exoid.fitting.amount.stretches import moving_parts, shortened
from exoid.fitting.data.fitted_samples import FEWEST
from exoid.recordings.recording import Recording
from exoid.recordings.selection import alike

NAMED = 5  # segments that a note lists by name


@dataclass(frozen=True)
class Amount:
    """What a fit takes."""

    segments: int = 128  # whose matrix grows with their square
    steps: int = 131_072  # of the simulation, of all segments together: 11 minutes at 200 Hz
    aim: int = 131_072  # steps to which more than that is brought down


TOGETHER = Amount()  # in 2 GB of memory
# With every cause that may be missing: eight drops of 20 s at 100 Hz stay whole.
DIAGNOSED = Amount(segments=24, steps=16_384, aim=12_288)


@dataclass(frozen=True, eq=False)
class Manageable:
    """The segments that are fitted, and what was left out of the others."""

    parts: list[Part]
    notes: list[str]


def manageable(
    named: Sequence[tuple[str, Recording]], most: Amount = TOGETHER, *, average: bool = True
) -> Manageable:
    """The segments of recordings; of more than `most` those, and of them what, tells most.

    Recordings within it are left as they are. Beyond, segments are taken evenly from all of them,
    rests are cut off, neighbouring samples averaged (not without `average`) as far as a motion
    allows, and what still is too long is fitted in part.

    **Raises** `ValueError` where a voluntary movement is longer than a fit takes.
    """
    every = parts_of(named)
    parts = with_same_sensors(every)
    others = said_of_sensors(every, parts)
    if len(parts) <= most.segments and size(parts) <= most.steps:
        return Manageable(parts, others)
    chosen = apart(spread(usable(parts), most.segments))
    notes = [*others, *said_of_number(len(parts), len(chosen))]
    if size(chosen) <= most.aim:
        return Manageable(chosen, notes)
    trimmed, count = moving_parts(chosen), 1
    if average and size(trimmed) > most.aim:
        trimmed, count = averaged(trimmed, most.aim // len(trimmed))
    fewer = spread(trimmed, whole_cycles(trimmed, most.aim))
    short, cut = shortened(fewer, most.aim // len(fewer))
    notes = [*others, *said_of_number(len(parts), len(fewer))]
    return Manageable(short, [*notes, *said_of_means(count), *said_of_stretches(cut)])


def size(parts: list[Part]) -> int:
    """The steps of a simulation, in which all are as long as the longest."""
    return len(parts) * max(part.steps for part in parts)


def usable(parts: list[Part]) -> list[Part]:
    """Without those of too few samples, unless all are."""
    enough = [
        part for part in parts if np.count_nonzero(~np.isnan(part.segment.best_angle)) >= FEWEST
    ]
    return enough or parts


def whole_cycles(parts: list[Part], steps: int) -> int:
    """How many segments fit into so many steps with no voluntary movement cut in two."""
    cycles = {part.name: part.steps for part in parts if part.kind == "active"}
    if not cycles:
        return len(parts)
    name = max(cycles, key=cycles.__getitem__)
    if cycles[name] > steps:
        raise ValueError(
            f"segment {name} is one voluntary movement of {cycles[name]} samples, more than the "
            f"{steps} that a fit takes, and Eq. 10 knows one cycle after a rest: mark the cycles "
            "with segment_start_s and segment_end_s, or say cycle_period_s."
        )
    return min(len(parts), steps // cycles[name])


def with_same_sensors(parts: list[Part]) -> list[Part]:
    """Without segments that lack a sensor which the others of their recording have, or have one
    that those lack.
    """
    usual = {part.belongs: part.recording for part in parts}
    numbers = {belongs: frozenset(alike(one)) for belongs, one in usual.items()}
    kept = [part for part in parts if part.number in numbers[part.belongs]]
    return parts if len(kept) == len(parts) else apart(kept)


def said_of_sensors(every: list[Part], kept: list[Part]) -> list[str]:
    others = sorted({part.name for part in every} - {part.name for part in kept})
    if not others:
        return []
    were = "was" if len(others) == 1 else "were"
    return [f"{among(others)} {were} left out: not of the same channels as the others"]


def said_of_number(whole: int, kept: int) -> list[str]:
    if kept == whole:
        return []
    return [
        f"of {whole} segments {kept} are fitted, taken evenly from all of them: more are too much "
        "for one fit. 'exoid fit --each' takes every one by itself"
    ]


def said_of_means(count: int) -> list[str]:
    if count == 1:
        return []
    return [
        f"means over {count} samples are fitted, their noise less accordingly: the samples are "
        "more than one fit takes, and come faster than the motion needs"
    ]


def said_of_stretches(cut: dict[str, str]) -> list[str]:
    """Segments of which the same is fitted together."""
    alike: dict[str, list[str]] = {}
    for name, what in cut.items():
        alike.setdefault(what, []).append(name)
    said = [f"{what} of {among(names)}" for what, names in alike.items()]
    others = ", and likewise of others" if len(said) > NAMED else ""
    if not said:
        return []
    return [f"fitted are {', '.join(said[:NAMED])}{others}: all of it is more than one fit takes"]


def among(names: list[str]) -> str:
    """Segments by their names, of many the first."""
    if len(names) == 1:
        return f"segment {names[0]}"
    others = f" and {len(names) - NAMED} others" if len(names) > NAMED else ""
    return f"segments {', '.join(names[:NAMED])}{others}"
