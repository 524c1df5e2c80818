"""What the errors of measures in seconds hold, where encoder and gyro disagree in scale.

A gyro shows (1 + s) times the angle's slope where its scale is off by s, or the encoder's gain, or
where all times are told a factor 1 + s too long. Within 3 % most are gyros as their data sheets
have them, and nothing is said of those; beyond that a clock is about as likely.
"""

from dataclasses import replace
from math import hypot

from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.landmarks.measure import Measure
from exoid.recordings.measured.segment import Segment
from exoid.recordings.signal.both_sensors.apart_in_scale import apart_in_scale
from exoid.recordings.signal.both_sensors.sensor_scales import GYRO_SCALE, suspected

BEYOND = 2.0  # times it, within which 19 of 20 gyros are
POWERS = {"s": 1, "rad/s": -1, "rad/s^2": -2}  # of a second, by unit


def with_doubted_clock(
    measures: dict[str, Measure], segment: Segment, sensors: Sensors
) -> tuple[dict[str, Measure], str | None]:
    """The measures, with errors that hold what of a disagreement may be the clock's, and what to
    say of it; None where the two agree, and where the sidecar says how well the clock is known.
    """
    usual = sensors.gyro_scale_uncertainty
    most = BEYOND * max(GYRO_SCALE, 0.0 if usual is None else usual)
    scale = apart_in_scale(segment.time, segment.raw_angle, segment.raw_angular_velocity)
    if sensors.clock_uncertainty is not None or scale is None or abs(scale) < most:
        return measures, None
    clock = suspected(scale)
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
