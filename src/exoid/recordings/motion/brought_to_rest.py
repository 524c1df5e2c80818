"""A leg that somebody, or a muscle, brings to rest, beside one that comes to rest by itself.

What springs and gravity make a leg do takes as long in a small swing as in a large one, and swings
shrink by a factor (viscous damping) and a step (dry friction): three of them tell both. A hand that
yields adds a spring, so that a swing is over too soon, and damping, so that the leg stands while it
should still swing.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from exoid.recordings.measured.samples import Samples
from exoid.recordings.motion.thresholds import AHEAD, HURRIED, LOSING, STICKING


@dataclass(frozen=True, eq=False)
class Course:
    """A motion from turning point to turning point: from the release to the rest or the end."""

    angle: Samples  # rad, there
    time: Samples  # s
    seen: NDArray[np.bool_]  # true of a swing without a hole
    rested: bool  # else the recording ends before
    least: float  # rad, of a swing
    noise: float  # rad, of a turning point
    step: float  # s

    @cached_property
    def size(self) -> Samples:
        """Of every swing [rad]."""
        return np.abs(np.diff(self.angle))

    @cached_property
    def lasting(self) -> Samples:
        """How long it takes [s] at most; a turning point is known to a sample."""
        return np.diff(self.time) + self.step / 2


def brought_to_rest(course: Course) -> int | None:
    """The turning point, by its number, from which on a leg swings as none does by itself; None of
    a leg that may.
    """
    ends = course.size.size - 1  # this swing ends at rest, or with the recording
    for swing in range(2, ends + course.rested):
        if not course.seen[max(swing - 2 - AHEAD, 0) : swing + 1].all():
            continue
        if swing < ends and hurried(course, swing):
            return swing
        last = last_before_loss(course, swing, resting=swing == ends)
        if last is not None:
            return last + 1
    return None


def hurried(course: Course, swing: int) -> bool:
    """Is a swing over long before those before it, of a size that tells?

    Noise moves a turn by as long as the leg is within it there: A (w t)^2 / 2 of the amplitude A.
    """
    usual = float(np.median(course.lasting[max(1, swing - 3) : swing]))
    smaller = float(course.size[swing - 1 : swing + 1].min())
    lasted = course.lasting[swing] + 2 / np.pi * usual * (course.noise / smaller) ** 0.5
    return any(smaller > size * course.least and lasted < share * usual for size, share in HURRIED)


def last_before_loss(course: Course, swing: int, *, resting: bool) -> int | None:
    """The swing, one or two before, from which a leg cannot have lost so much by itself; None of
    one that may.
    """
    for steps in range(1, min(AHEAD, swing - 2) + 1):
        before = course.size[: swing - steps + 1]
        if not (np.diff(before[-3:]) < 0).all():
            continue
        expected = expected_after(before, steps)
        most = max(LOSING * expected, course.least / 2)
        if resting:
            whole, lost = STICKING
            most = whole * course.least + lost * float(before[-2] - before[-1])
        if expected - course.size[swing] > steps * most:
            return swing - steps
    return None


def expected_after(before: Samples, steps: int) -> float:
    """The least that a swing may be so many `steps` after those before it.

    By its law s' = q s - c, with c >= 0 and q <= 1, as the last three tell. Something that is slow
    shifts the angle about which a leg swings, so that every second swing shrinks more: none shrinks
    more than one did before, the fall left aside where there are others.
    """
    shares = before[1:] / before[:-1]
    usual = float(shares[int(shares.size > 2) :].min()) ** steps * float(before[-1])
    first, second, swing = before[-3:].tolist()
    share = min(max((second - swing) / (first - second), swing / second), 1.0)
    step = share * second - swing
    for _ in range(steps):
        swing = share * swing - step
    return min(swing, usual)
