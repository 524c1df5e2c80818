"""What the firmware tells of what it knows, in NumPy float32: of many legs at a time."""

from dataclasses import dataclass

import numpy as np
from float32_leg import UNKNOWN
from float32_movement import Kept
from float32_sine import F, root

from exoid.recordings.filter.learning import LEARNING

SCALE, LEVEL, UPRIGHT, STIFFNESS, TORQUE, DAMPING = range(UNKNOWN)


@dataclass
class Learned:
    """What nodes say: ratios and errors of gravity, stiffness, damping, torque, by leg."""

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
    others = [leg.covariance(k, k) for k in (STIFFNESS, DAMPING, TORQUE)]
    least = np.array(LEARNING.least_error, F)[:, None]
    errors = np.stack([root(wider * each) for each in (along / square, *others)])
    ratios = np.stack([root(square), leg.mean[STIFFNESS], leg.mean[DAMPING], leg.mean[TORQUE]])
    return Learned(ratios, np.where(errors > least, errors, least), mean)


def is_within(found: Learned, share: float):
    gravity, limit = found.ratio[0], F(share)
    of_gravity = (found.error[0] < limit * gravity) & (found.error[1] < limit * gravity)
    return of_gravity & (found.error[2] * found.error[2] < limit * limit * gravity)
