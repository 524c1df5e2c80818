"""What is read off an angle that drifts: the angle less a line, and errors that hold the other.

The angle about which a leg swings and at which it hangs stays, so that one that moves evenly is a
sensor that drifts. A leg that sinks looks alike: the errors allow for it. Where the hanging leg
alone moves, the angle is read as it is, and the errors allow for a drift.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from math import degrees, hypot

import numpy as np

from exoid.pendulum.catalogue import measures
from exoid.pendulum.slope import Slope, slope_at_rest, slope_of_swings
from exoid.recordings.landmarks.landmarks import Landmarks
from exoid.recordings.landmarks.measure import Measure, NotAllowed
from exoid.recordings.landmarks.track import SURE, Track

CLEAR = 2.0  # standard errors of the swings' own slope, where both are told together
WHERE = ("about which it swings", "at which it hangs")
EITHER = 3**-0.5  # of what two readings differ by: the truth is anywhere from one to the other


@dataclass(frozen=True, eq=False)
class Reading:
    """The landmarks of a drop, its measures, and what to say of the angle's drift."""

    landmarks: Landmarks
    measures: dict[str, Measure]
    note: str | None = None
    drift: float = 0.0  # rad/s, taken off the angle


@dataclass(frozen=True)
class Moving:
    """How fast an angle moves that should stay, whether evenly all the time, and which it is."""

    slope: Slope
    evenly: bool
    where: str


def read_off(track: Track, find: Callable[[Track], Landmarks]) -> Reading:
    """What `find` finds on a track, mended of a drift.

    **Raises** `NotAllowed` where `find` does.
    """
    found = find(track)
    plain = Reading(found, measures(found))
    seen = found.uncounted is None  # to the last turn, after which it hangs
    hanging = slope_at_rest(found.track, found.turns) if seen else None
    moves = moving(slope_of_swings(found.free_turns), hanging)
    if moves is None:
        return plain
    since = np.maximum(track.time, found.begin) - track.time[0]  # a line would move the hold
    line = moves.slope.value * since
    try:
        level = find(replace(track, angle=track.angle - line))
    except NotAllowed:
        return plain
    other = Reading(level, measures(level))
    if moves.evenly:
        said = of_drift(moves, plain)
        return Reading(level, beside(other, plain), said, moves.slope.value)
    return Reading(found, beside(plain, other), of_sinking(moves, other))


def moving(swings: Slope | None, hanging: Slope | None) -> Moving | None:
    """How fast the angle moves about which a leg swings and at which it hangs, and whether that is
    evenly; None where it stays.
    """
    told = [each for each in (swings, hanging) if each is not None]
    if not told:
        return None
    surest = max(told, key=lambda each: abs(each.value) / each.error)
    if swings is not None and hanging is not None:
        both = together(swings, hanging)
        if both is not None and both.sure and swings.clear(CLEAR):
            return Moving(both, True, "about which it swings and at which it hangs")
    if not surest.sure:
        return None
    if hanging is None:
        return Moving(surest, True, "about which it swings")
    return Moving(surest, False, WHERE[surest is hanging])


def together(one: Slope, other: Slope) -> Slope | None:
    """The mean of two that are alike within their errors, else None."""
    apart, unsure = other.value - one.value, hypot(one.error, other.error)
    if abs(apart) > SURE * unsure:
        return None
    share = (one.error / unsure) ** 2
    return Slope(one.value + share * apart, one.error * other.error / unsure)


def beside(one: Reading, other: Reading) -> dict[str, Measure]:
    """The measures of one reading, with errors that hold those of the other."""
    return {name: allowing(each, other.measures[name]) for name, each in one.measures.items()}


def allowing(each: Measure, other: Measure) -> Measure:
    if each.value is None or each.standard_error is None or other.value is None:
        return each
    apart = EITHER * (each.value - other.value)
    return replace(each, standard_error=hypot(each.standard_error, apart))


def of_drift(moves: Moving, recorded: Reading) -> str:
    return (
        f"the angle {moves.where} moves by {told(moves.slope)}, as where the angle's sensor "
        "drifts: everything is read off the angle less that, from the begin of the segment on, and "
        f"± allows for a leg that moves so instead{told_by(recorded)}"
    )


def of_sinking(moves: Moving, level: Reading) -> str:
    return (
        f"the angle {moves.where} moves by {told(moves.slope)}, and not surely all the time: the "
        f"leg sinks, or the angle's sensor drifts, and ± allows for either{told_by(level)}"
    )


def told(slope: Slope) -> str:
    return f"{degrees(slope.value):+.2f} ± {degrees(slope.error):.2f} deg/s"


def told_by(other: Reading) -> str:
    """Plateau and relaxation index of the other reading, where it has them."""
    plateau = other.measures["plateau_angle"].value
    index = other.measures["expected_relaxation_index"].value
    each = (
        None if plateau is None else f"a plateau of {degrees(plateau):.1f} deg",
        None if index is None else f"a relaxation index of {index:.3f}",
    )
    said = " and ".join(filter(None, each))
    return f" (that would be {said})" if said else ""
