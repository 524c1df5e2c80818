"""How a gyro differs from the encoder beside it, by the two alone: whatever moved the leg."""

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from exoid.recordings.signal.condition import SMOOTHING
from exoid.recordings.signal.local_line import local_line

FEWEST = 30  # samples
SURE = 5.0  # standard errors
SCALE = 0.05  # relative, three times what a gyro is out of the box
LATE = 0.003  # s, five times what the age of a node's sample may be off


@dataclass(frozen=True)
class GyroOff:
    """What a gyro shows: so many times the rate of the encoder's angle, and so late [s]; 1 and 0
    where that is not sure.
    """

    scale: float
    late: float


def gyro_off(rows: Float[np.ndarray, "row 6"]) -> GyroOff | None:
    """By samples of one movement; None where encoder and gyro agree, or one of them is not there.

    A rate shown t_s late is v - t_s v' to first order, v the slope of the angle.
    """
    time, angle, rate = rows[np.isfinite(rows[:, :3]).all(axis=1), :3].T
    if time.size < FEWEST:
        return None
    slope = local_line(time, angle, SMOOTHING)[1]
    shown, change = local_line(time, rate, SMOOTHING)
    found, error = least_squares(np.column_stack([slope, -change, np.ones_like(slope)]), shown)
    share = max(1.0, SMOOTHING * (time.size - 1) / np.ptp(time))  # samples that share their noise
    off = np.abs(found - [1.0, 0.0, 0.0])
    scaled, late, _ = off > np.maximum([SCALE, LATE, 0.0], SURE * np.sqrt(share) * error)
    if not (scaled or late):
        return None
    return GyroOff(float(found[0]) if scaled else 1.0, float(found[1]) if late else 0.0)


def least_squares(
    columns: Float[np.ndarray, "row 3"], values: Float[np.ndarray, " row"]
) -> tuple[Float[np.ndarray, "3"], Float[np.ndarray, "3"]]:
    """What each column counts, and its standard error where rows share no noise."""
    found, *_ = np.linalg.lstsq(columns, values, rcond=None)
    variance = np.square(values - columns @ found).sum() / max(len(values) - 3, 1)
    return found, np.sqrt(variance * np.diag(np.linalg.pinv(columns.T @ columns)))
