"""What the errors of measures in seconds hold, where encoder and gyro disagree in scale.

A gyro shows (1 + s) times the angle's slope where its scale is off by s, or the encoder's gain, or
where all times are told a factor 1 + s too long. Within 3 % most are gyros as their data sheets
have them, and nothing is said of those; beyond that a clock is about as likely.
"""

from dataclasses import replace
from math import hypot

import numpy as np

from exoid.recordings.landmarks.measure import Measure
from exoid.recordings.recording import Segment, Sensors
from exoid.recordings.signal.both_sensors.sensor_scales import FARTHEST, GYRO_SCALE, SUSPECTED
from exoid.recordings.signal.condition import SMOOTHING
from exoid.recordings.signal.local_line import local_line

BEYOND = 2.0  # times it, within which 19 of 20 gyros are
LEFT = 0.2  # of the squares by which the two differ, that another scale may leave at most
FAST = 0.3  # of the greatest slope, from where on the noise of a slope does not matter
FEWEST = 20  # samples that tell a scale
POWERS = {"s": 1, "rad/s": -1, "rad/s^2": -2}  # of a second, by unit


def with_doubted_clock(
    measures: dict[str, Measure], segment: Segment, sensors: Sensors
) -> tuple[dict[str, Measure], str | None]:
    """The measures, with errors that hold what of a disagreement may be the clock's, and what to
    say of it; None where the two agree, and where the sidecar says how well the clock is known.
    """
    usual = sensors.gyro_scale_uncertainty
    most = BEYOND * max(GYRO_SCALE, 0.0 if usual is None else usual)
    scale = disagreement(segment)
    if sensors.clock_uncertainty is not None or scale is None or abs(scale) < most:
        return measures, None
    clock = SUSPECTED * min(abs(scale), FARTHEST)
    return {name: by_clock(each, clock) for name, each in measures.items()}, (
        f"gyro and encoder disagree by {100 * scale:+.0f} % in scale: it is the gyro's, or the "
        "encoder's gain, or the rate of the clock, and no motion tells which. Nothing here is read "
        "off the gyro; ± of times, velocities and accelerations allows for the clock: compare it "
        "with a true one and give clock_uncertainty"
    )


def by_clock(each: Measure, clock: float) -> Measure:
    """A measure whose error holds a clock that is off by a share of this standard deviation."""
    power = POWERS.get(each.unit)
    if power is None or each.value is None or each.standard_error is None:
        return each
    return replace(each, standard_error=hypot(each.standard_error, power * clock * each.value))


def disagreement(segment: Segment) -> float | None:
    """By how much a raw gyro shows more than the encoder's slope, relative; None where there is
    none, and where it is not mostly a scale that tells the two apart.
    """
    angle, gyro = segment.raw_angle, segment.raw_angular_velocity
    if angle is None or gyro is None:
        return None
    seen = ~np.isnan(angle) & ~np.isnan(gyro)
    slope = local_line(segment.time, angle, SMOOTHING)[1]
    rate = local_line(segment.time, gyro, SMOOTHING)[0]
    seen &= np.abs(slope) > FAST * np.quantile(np.abs(slope), 0.99)
    if seen.sum() < FEWEST:
        return None
    slope, rate = slope[seen], rate[seen]
    columns = np.stack([slope, np.ones_like(slope)], axis=1)
    (gain, bias), *_ = np.linalg.lstsq(columns, rate, rcond=None)
    apart = np.sum((rate - slope - np.mean(rate - slope)) ** 2)
    left = np.sum((rate - gain * slope - bias) ** 2)
    return float(gain - 1) if left < LEFT * apart else None
