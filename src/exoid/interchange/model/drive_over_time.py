"""What drove a segment, as numbers over time."""

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

from exoid.interchange.formula.expression import Expression, evaluate
from exoid.interchange.model.formulas import torque_over_time
from exoid.interchange.model.joint import Joint
from exoid.physics.motion.step import parabola
from exoid.physics.torque import MeasuredTorque

OFF = 1e-4  # of the largest torque, by which straight lines may be off the fit's own
MOST = 64  # lines of a step, where the torque jumps


class Drive(NamedTuple):
    """Straight between its numbers."""

    time: np.ndarray  # s
    torque: np.ndarray  # N m


def drive_over_time(joint: Joint, more: Iterable[Expression] = ()) -> Drive:
    """As the fit had it: through its value at the begin, middle and end of every step.

    `more` are torques of terms, of which what hangs on time alone is a part of it.
    """
    edges = joint.edges
    begin, size = edges[:-1], np.diff(edges)
    timed = [each for each in more if "time" in each.symbols]

    def torque(time: np.ndarray) -> np.ndarray:
        values = {**joint.constants, "angle": 0.0, "rate": 0.0, "time": time}
        formulas = [torque_over_time(joint.drive), *timed]
        known = sum(evaluate(each, values) for each in formulas) + np.zeros_like(time)
        if isinstance(joint.drive, MeasuredTorque):
            known = known + np.interp(time, joint.drive.time, joint.drive.torque)
        return known

    first, middle, last = torque(begin), torque(begin + size / 2), torque(begin + size)
    bends = first - 2 * middle + last
    counts = lines(bends, OFF * np.abs([first, middle, last]).max(initial=0.0))
    above = bends / (3 * counts**2)  # of a parabola, in the mean, are lines from it to it
    shared = np.append(above[:1], above[:-1])
    times, torques = [], []
    for at, count in enumerate(counts):
        inside = np.arange(count) / count
        off = np.append((shared[at] + above[at]) / 2, np.full(count - 1, above[at]))
        times.append(begin[at] + inside * size[at])
        torques.append(parabola(first[at], middle[at], last[at], inside) - off)
    time = np.append(np.hstack(times), edges[-1])
    return Drive(time, np.append(np.hstack(torques), last[-1] - above[-1]))


def lines(bends: np.ndarray, off: float) -> np.ndarray:
    """How many straight lines stay within `off` of each parabola, whose begin and end, less twice
    its middle, `bends` are: a line is off by half of that, n lines by 1 / n^2 of it.
    """
    wanted = np.sqrt(np.abs(bends) / (2 * off)) if off else np.ones_like(bends)
    return np.clip(np.ceil(wanted), 1, MOST).astype(int)
