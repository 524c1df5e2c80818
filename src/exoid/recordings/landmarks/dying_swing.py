"""The angle about which a leg swings that is nearly at rest."""

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from exoid.recordings.landmarks.track import Peak
from exoid.recordings.measured.samples import Samples

# Of the log of the rate (a soft leg swings slower the less it swings) and of the decay in a radian:
# standard deviations from those of the swings before.
SAME = (0.1, 0.05)
# Of the amplitude squared [rad]: as much gravity, which bends with the angle, shifts the middle of
# a leg that hangs at -60 deg or lower, at most.
BENT = 1 / 8
STANDING = (0.5, 0.25)  # of the samples, the last of which may be of a leg that stands still
STOPPED = 4.0  # of twice the log likelihood by which it does so rather than swing: one in seven
BLOCKS = 10  # of what is left, whose means tell what is slow in it
UNLIKELY = 3.0  # standard deviations of their chi-square beyond which it is no such swing


@dataclass(frozen=True)
class Middle:
    """An angle with its standard error [rad]."""

    value: float
    error: float


def middle_of(time: Samples, angle: Samples, noise: float, turns: list[Peak]) -> Middle | None:
    """The middle psi of a swing that shrinks by a factor, about as those of the last three `turns`,

        psi + exp(-k w t) (a cos(w t) + b sin(w t)),

    by least squares; None where it does not swing so, as where friction stops it.
    """
    before = swings_of(turns)
    if before is None or not noise > 0:
        return None
    since = time - time[0]
    begun = np.array([angle.mean(), 0.0, 0.0, *before])

    def misfit(numbers: Float[np.ndarray, "5"]) -> Float[np.ndarray, " row"]:
        apart = (numbers[3:] - before) / SAME
        return np.concatenate([(angle - swing(since, numbers)) / noise, apart])

    from scipy.optimize import least_squares  # long to import, and for legs that still swing alone

    found = least_squares(misfit, begun, x_scale=[noise, noise, noise, *SAME])
    left = (angle - swing(since, found.x)) / noise
    if not is_white(left) or stands(angle / noise, left):
        return None
    covariance = np.linalg.inv(found.jac.T @ found.jac)
    bent = BENT * (found.x[1] ** 2 + found.x[2] ** 2)
    return Middle(float(found.x[0]), float(np.hypot(np.sqrt(covariance[0, 0]), bent)))


def is_white(left: Samples) -> bool:
    """Is what is left, over the noise, nothing but noise?"""
    parts = [each for each in np.array_split(left, BLOCKS) if each.size]
    square = sum(each.size * each.mean() ** 2 for each in parts)
    return bool(square < len(parts) + UNLIKELY * np.sqrt(2 * len(parts)))


def stands(angle: Samples, left: Samples) -> bool:
    """Do the last samples look like a leg at rest, rather than like that swing? Over the noise."""
    ends = ((angle[begin:], left[begin:]) for begin in (int((1 - p) * left.size) for p in STANDING))
    return any(np.sum((at - at.mean()) ** 2) + STOPPED < np.sum(off**2) for at, off in ends)


def swing(since: Samples, numbers: Float[np.ndarray, "5"]) -> Samples:
    """The angle [rad] so long [s] after the first sample."""
    middle, a, b, rate, decay = numbers
    phase = np.exp(rate) * since
    return middle + np.exp(-decay * phase) * (a * np.cos(phase) + b * np.sin(phase))


def swings_of(turns: list[Peak]) -> Float[np.ndarray, "2"] | None:
    """The log of the rate [rad/s] of the last full swing, and its decay in a radian; None where
    there is none, or it does not shrink.
    """
    if len(turns) < 3:
        return None
    first, middle, last = turns[-3:]
    share = abs(last.value - middle.value) / abs(middle.value - first.value)
    if share >= 1.0:
        return None
    return np.array([np.log(2 * np.pi / (last.time - first.time)), -np.log(share) / np.pi])
