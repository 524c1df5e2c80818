"""By how much a gyro shows more than the encoder's own slope: without a model of what moves."""

import numpy as np

from exoid.recordings.measured.samples import Samples
from exoid.recordings.signal.condition import SMOOTHING
from exoid.recordings.signal.local_line import local_line

LEFT = 0.2  # of the squares by which the two differ, that another scale may leave at most
FAST = 0.3  # of the greatest slope, from where on the noise of a slope does not matter
FEWEST = 20  # samples that tell a scale


def apart_in_scale(time: Samples, angle: Samples | None, gyro: Samples | None) -> float | None:
    """The gyro's rate [rad/s] over the slope of the angle [rad], less 1; None where one of them is
    missing, and where it is not mostly a scale that tells the two apart.
    """
    if angle is None or gyro is None:
        return None
    seen = ~np.isnan(angle) & ~np.isnan(gyro)
    slope = local_line(time, angle, SMOOTHING)[1]
    rate = local_line(time, gyro, SMOOTHING)[0]
    seen &= np.abs(slope) > FAST * np.quantile(np.abs(slope), 0.99)
    if seen.sum() < FEWEST:
        return None
    slope, rate = slope[seen], rate[seen]
    columns = np.stack([slope, np.ones_like(slope)], axis=1)
    (gain, bias), *_ = np.linalg.lstsq(columns, rate, rcond=None)
    apart = np.sum((rate - slope - np.mean(rate - slope)) ** 2)
    left = np.sum((rate - gain * slope - bias) ** 2)
    return float(gain - 1) if left < LEFT * apart else None
