"""How complete and how clean the segments of a recording are."""

from dataclasses import dataclass

import numpy as np

from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.measured.segment import Segment

GAP = 1.5  # usual steps, from which on a step has lost a sample
FULL = 0.999  # of a gyro's range, from which on it is at its end


@dataclass(frozen=True)
class Appraisal:
    """One segment."""

    samples: int
    duration: float  # s
    rate: float  # Hz
    gaps: int
    longest: float  # s, of the gaps; 0 without one
    missing: int  # samples without an angle
    saturated: int | None  # samples of the gyro at the end of its range; None where unknown


def appraise(segment: Segment, sensors: Sensors) -> Appraisal:
    """Count what is lost."""
    steps = np.diff(segment.time)
    usual = float(np.median(steps))
    gaps = steps[steps > GAP * usual]
    angle = segment.angle if segment.raw_angle is None else segment.raw_angle
    assert angle is not None  # a Segment has one or the other
    return Appraisal(
        samples=segment.time.size,
        duration=float(segment.time[-1] - segment.time[0]),
        rate=1 / usual,
        gaps=gaps.size,
        longest=float(gaps.max(initial=0.0)),
        missing=int(np.isnan(angle).sum()),
        saturated=saturated(segment, sensors.gyro_range),
    )


def saturated(segment: Segment, limit: float | None) -> int | None:
    """Samples of the gyro at the end of its range `limit` [deg/s]."""
    gyro = segment.raw_angular_velocity
    if gyro is None or limit is None:
        return None
    return int(np.sum(np.abs(np.degrees(gyro)) >= FULL * limit))
