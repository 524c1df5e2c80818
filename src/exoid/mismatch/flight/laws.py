"""The laws of motion of a frame and of the leg that it is on, each by itself, from accelerations.

Both are linear: that of the frame in its gravity, damping and dry friction over its inertia, that
of the leg in m l g / J, c / J and d / J and the size of another cause.
"""

import numpy as np

from exoid.mismatch.flight.accelerations import Accelerations

SURE = 0.3  # rad/s^2, below which residuals count alike
ROUNDS = 30
LEAST = 6  # accelerations that tell a law


def of_frame(seen: Accelerations) -> np.ndarray | None:
    """Gravity [1/s^2], damping [1/s] and dry friction [rad/s^2] of the frame over its inertia."""
    if seen.flying.sum() < LEAST:
        return None
    return straight(swings(seen)[seen.flying], seen.value[seen.flying])[0]


def of_leg(
    seen: Accelerations, frame: np.ndarray, share: float, *others: np.ndarray
) -> tuple[np.ndarray, float]:
    """m l g / J, c / J, d / J, and the factors of what else pushes per J [rad/s^2], where the
    frame's inertia is this share of J; and how large the residuals are [rad/s^2].
    """
    along = (np.cos(seen.angle), seen.angle, seen.angular_velocity)
    columns = np.stack([*(-each for each in along), *others], axis=-1)
    alone = (1 + share) * seen.value - share * (swings(seen) @ frame)
    return straight(columns[seen.joined], alone[seen.joined])


def swings(seen: Accelerations) -> np.ndarray:
    """What each number of the frame's law does: (segment, step, number)."""
    rate = seen.angular_velocity
    return -np.stack([np.cos(seen.angle), rate, np.sign(rate)], axis=-1)


def straight(columns: np.ndarray, value: np.ndarray) -> tuple[np.ndarray, float]:
    """The factors of columns of which the mean size of the residuals is least, and that size: a few
    accelerations of another law count little (Schlossmacher, J. Am. Stat. Assoc. 68, 1973).
    """
    factors = np.linalg.lstsq(columns, value, rcond=None)[0]
    for _ in range(ROUNDS):
        left = np.abs(value - columns @ factors)
        weight = 1 / np.sqrt(np.maximum(left, SURE))
        rows = columns * weight[:, None], value * weight
        factors = np.linalg.lstsq(*rows, rcond=None)[0]
    return factors, float(np.mean(np.abs(value - columns @ factors)))
