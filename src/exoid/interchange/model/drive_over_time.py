"""What drove a segment, as numbers over time."""

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

from exoid.interchange.formula.expression import Expression, evaluate
from exoid.interchange.model.formulas import torque_over_time
from exoid.interchange.model.joint import Joint
from exoid.physics.motion.step import parabola
from exoid.physics.torque import MeasuredTorque

QUARTERS = np.linspace(0.0, 1.0, 4, endpoint=False)  # of a sample's step, at which it is told


class Drive(NamedTuple):
    """Straight between its numbers."""

    time: np.ndarray  # s
    torque: np.ndarray  # N m


def drive_over_time(joint: Joint, more: Iterable[Expression] = ()) -> Drive:
    """As the fit had it: through its value at the begin, middle and end of every sample's step.

    `more` are torques of terms, of which what hangs on time alone is a part of it.
    """
    begin, size = joint.times[:-1, None], np.diff(joint.times)[:, None]
    timed = [each for each in more if "time" in each.symbols]

    def torque(time: np.ndarray) -> np.ndarray:
        values = {**joint.constants, "angle": 0.0, "rate": 0.0, "time": time}
        formulas = [torque_over_time(joint.drive), *timed]
        known = sum(evaluate(each, values) for each in formulas) + np.zeros_like(time)
        if isinstance(joint.drive, MeasuredTorque):
            known = known + np.interp(time, joint.drive.time, joint.drive.torque)
        return known

    stages = (torque(begin), torque(begin + size / 2), torque(begin + size))
    time, between = begin + QUARTERS * size, parabola(*stages, QUARTERS)
    last = stages[2][-1]
    return Drive(np.append(time, joint.times[-1]), np.append(between, last))
