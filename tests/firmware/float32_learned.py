"""What the firmware tells of what it knows, in NumPy float32: of many legs at a time."""

from dataclasses import dataclass

import numpy as np
from float32_leg import UNKNOWN, Factored
from float32_movement import Kept
from float32_sine import F, root, turned

from exoid.recordings.filter.learning import LEARNING, SENSED

LEVEL, UPRIGHT, STIFFNESS, TORQUE, DAMPING, FRICTION = range(len(SENSED), UNKNOWN)


@dataclass
class Learned:
    """What nodes say: ratios and errors in the order of RATIOS, by leg."""

    ratio: np.ndarray
    error: np.ndarray
    surprise: np.ndarray


def learned(kept: Kept) -> Learned:
    leg, two = kept.leg, F(2)
    level, upright = leg.mean[LEVEL], leg.mean[UPRIGHT]
    square = level * level + upright * upright
    along = (
        level * level * leg.covariance(LEVEL, LEVEL)
        + two * level * upright * leg.covariance(LEVEL, UPRIGHT)
        + upright * upright * leg.covariance(UPRIGHT, UPRIGHT)
    )
    mean = kept.squares / np.maximum(kept.counted, 1).astype(F)
    wider = F(LEARNING.caution) * np.where(mean > 1, mean, F(1))
    others = [leg.covariance(k, k) for k in (STIFFNESS, DAMPING, TORQUE, FRICTION)]
    least = np.array(LEARNING.least_error, F)[:, None]
    errors = np.stack([root(wider * each) for each in (along / square, *others)])
    means = [leg.mean[k] for k in (STIFFNESS, DAMPING, TORQUE, FRICTION)]
    ratios = np.stack([root(square), *means])
    return Learned(ratios, np.where(errors > least, errors, least), mean)


def is_within(found: Learned, share: float):
    gravity, limit = found.ratio[0], F(share)
    of_gravity = (found.error[0] < limit * gravity) & (found.error[1] < limit * gravity)
    return of_gravity & (found.error[2] * found.error[2] < limit * limit * gravity)


def expected_leg(legs: int) -> Kept:
    leg = Kept.nothing(legs)
    leg.leg.mean[:] = np.array(LEARNING.expected, F)[:, None]
    leg.leg.variance[:] = (np.array(LEARNING.scatter, F) ** 2)[:, None]
    return leg


def fall(leg: Factored, angle):
    sine, cosine = turned(angle)
    mean = leg.mean
    return mean[TORQUE] - (mean[LEVEL] * cosine + mean[UPRIGHT] * sine) - mean[STIFFNESS] * angle


def differ(one: Factored, other: Factored):
    gravity = one.mean[LEVEL]
    squared, matters = gravity * gravity, F(LEARNING.matters) * F(LEARNING.matters)
    found = np.zeros(gravity.size, bool)
    for k, size in ((LEVEL, squared), (STIFFNESS, squared), (DAMPING, gravity)):
        apart = other.mean[k] - one.mean[k]
        both = one.covariance(k, k) + other.covariance(k, k)
        square = apart * apart
        found |= (square > F(LEARNING.apart) * both) & (square > matters * size)
    return found
