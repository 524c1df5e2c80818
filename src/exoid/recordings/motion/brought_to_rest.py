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
from exoid.recordings.motion.thresholds import HALTED, HURRIED, WANTING


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
        if not course.seen[max(swing - 3, 0) : swing + 1].all():
            continue
        if (swing < ends and hurried(course, swing)) or curtailed(course, swing, swing == ends):
            return swing
    return None


def hurried(course: Course, swing: int) -> bool:
    """Is a swing over long before those before it, of a size that tells?

    Noise moves a turn by as long as the leg is within it there: A (w t)^2 / 2 of the amplitude A.
    """
    usual = float(np.median(course.lasting[max(1, swing - 3) : swing]))
    smaller = float(course.size[swing - 1 : swing + 1].min())
    lasted = course.lasting[swing] + 2 / np.pi * usual * (course.noise / smaller) ** 0.5
    return any(smaller > size * course.least and lasted < share * usual for size, share in HURRIED)


def curtailed(course: Course, swing: int, resting: bool) -> bool:
    """Does it end long before the three swings before it let expect?

    A stop or a reflex may make the swing after the fall small: of a leg that rests after three
    swings, the fall is one of these.
    """
    before = course.size[max(swing - 3, 0) : swing]
    if swing < (3 if resting else 4) or not (np.diff(before) < 0).all():
        return False
    expected = next_swing(*before.tolist())
    share = 0.0 if resting and swing > 3 else HALTED
    return bool(expected - course.size[swing] > max(WANTING * course.least, share * expected))


def next_swing(first: float, second: float, third: float) -> float:
    """s' = q s - c, with c >= 0 and q <= 1, as three swings that shrink tell."""
    share = min(max((second - third) / (first - second), third / second), 1.0)
    return share * third - (share * second - third)
