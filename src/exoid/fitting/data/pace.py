"""How finely a recording must be simulated, and looked at, by how fast it moves."""

import numpy as np

from exoid.fitting.data.movement import Movement
from exoid.physics.motion.parts_of_a_step import parts_to_follow
from exoid.physics.term import Term
from exoid.recordings.remembered import remembered
from exoid.recordings.signal import turns
from exoid.recordings.signal.turns import QUICK

LONGEST_STEP = 0.02  # s; a gap or slow sampling is bridged by samples that weigh nothing
LEG = 5.0  # rad/s, a leg's pace
RADIANS = 0.2  # of an oscillation that a Runge-Kutta step may span: 0.2^4 / 120 is 1.3e-5 a radian
MOST_PARTS = 16  # of a step


@remembered  # every step of a fit asks for it
def pace(movement: Movement) -> float:
    """How many radians of an oscillation its angle passes in a second."""
    return turns.pace(movement.segment.time, movement.angle)


def quickest(movements: list[Movement]) -> float:
    """The pace of the quickest of them [rad/s]."""
    return max(map(pace, movements))


def parts_of(movements: list[Movement], terms: tuple[type[Term], ...] = ()) -> int:
    """Into how many parts a step of the simulation is cut: 1 of whatever is as slow as a leg."""
    steps = [float(np.median(np.diff(each.segment.time))) for each in movements]
    rates = map(pace, movements)
    wanted = [
        rate * step / RADIANS for rate, step in zip(rates, steps, strict=True) if rate > QUICK
    ]
    quick = int(min(np.ceil(max(wanted, default=1.0)), MOST_PARTS))
    return max(quick, parts_to_follow(terms, min(max(steps), LONGEST_STEP)))


def unhurried(movement: Movement, width: float) -> float:
    """A time over which a motion is smoothed [s], shorter where it moves faster than any leg."""
    rate = pace(movement)
    return width if rate <= QUICK else width * QUICK / (3 * rate)
