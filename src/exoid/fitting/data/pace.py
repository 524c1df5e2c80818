"""How fast a recording moves, and how finely it must therefore be simulated and looked at."""

import numpy as np

from exoid.fitting.data.movement import Movement
from exoid.recordings.samples import Samples
from exoid.recordings.signal.condition import interpolated

TURN = 0.1  # of its travel: how far it moves back before a turn counts
QUICK = 25.0  # rad/s: what turns less often is a leg, or as slow as one
RADIANS = 0.2  # of an oscillation that a Runge-Kutta step may span: 0.2^4 / 120 is 1.3e-5 a radian
MOST_PARTS = 16  # of a step


def pace(movement: Movement) -> float:
    """How many radians of an oscillation its angle passes in a second: pi from turn to turn.

    By the median time between turns, so that neither a rest nor a few quick ones count.
    """
    time = movement.segment.time
    at = turns(interpolated(time, movement.angle))
    if at.size < 3:
        return 0.0
    return float(np.pi / np.median(np.diff(time[at])))


def turns(angle: Samples) -> np.ndarray:
    """The samples of the extremes between which it moves by more than `TURN` of its travel."""
    least, found = TURN * float(np.ptp(angle)), []
    extreme, way = 0, 0.0  # way: +1 while it rises, 0 before it is known
    for at, value in enumerate(angle):
        ahead = value - angle[extreme]
        if way * ahead >= 0 and way != 0:
            extreme = at
        elif abs(ahead) > least:
            found.append(extreme)
            extreme, way = at, float(np.sign(ahead))
    return np.array(found, dtype=int)


def parts_of(movements: list[Movement]) -> int:
    """Into how many parts a step between samples is cut: 1 of whatever is as slow as a leg."""
    wanted = [pace(each) * np.median(np.diff(each.segment.time)) / RADIANS for each in movements]
    quick = [
        number
        for number, each in zip(wanted, movements, strict=True)
        if pace(each) > QUICK and number > 1
    ]
    return int(min(np.ceil(max(quick, default=1.0)), MOST_PARTS))


def unhurried(movement: Movement, width: float) -> float:
    """A time over which a motion is smoothed [s], shorter where it moves faster than any leg."""
    rate = pace(movement)
    return width if rate <= QUICK else width * QUICK / (3 * rate)
