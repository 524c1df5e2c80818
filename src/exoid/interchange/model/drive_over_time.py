"""What drove a segment, as numbers over time."""

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

from exoid.interchange.formula.expression import Expression, evaluate
from exoid.interchange.model.formulas import torque_over_time
from exoid.interchange.model.joint import Joint
from exoid.physics.motion.step import parabola
from exoid.physics.torque import MeasuredTorque

SMOOTH, SHARP = 4, 64  # numbers of a sample's step: where it hardly bends, and where it jumps
BEND = (
    1e-3  # of the largest torque, by which the middle of a step that hardly bends is off its line
)


class Drive(NamedTuple):
    """Straight between its numbers."""

    time: np.ndarray  # s
    torque: np.ndarray  # N m


def drive_over_time(joint: Joint, more: Iterable[Expression] = ()) -> Drive:
    """As the fit had it: through its value at the begin, middle and end of every sample's step.

    `more` are torques of terms, of which what hangs on time alone is a part of it.
    """
    begin, size = joint.times[:-1], np.diff(joint.times)
    timed = [each for each in more if "time" in each.symbols]

    def torque(time: np.ndarray) -> np.ndarray:
        values = {**joint.constants, "angle": 0.0, "rate": 0.0, "time": time}
        formulas = [torque_over_time(joint.drive), *timed]
        known = sum(evaluate(each, values) for each in formulas) + np.zeros_like(time)
        if isinstance(joint.drive, MeasuredTorque):
            known = known + np.interp(time, joint.drive.time, joint.drive.torque)
        return known

    first, middle, last = torque(begin), torque(begin + size / 2), torque(begin + size)
    bends = np.abs(first - 2 * middle + last) > BEND * np.abs(middle).max(initial=0.0)
    times, torques = [], []
    for at, parts in enumerate(np.where(bends, SHARP, SMOOTH)):
        inside = np.arange(parts) / parts
        times.append(begin[at] + inside * size[at])
        torques.append(parabola(first[at], middle[at], last[at], inside))
    time = np.append(np.hstack(times), joint.times[-1])
    return Drive(time, np.append(np.hstack(torques), last[-1]))
