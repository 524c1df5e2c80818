"""What is lost of a segment is counted."""

import numpy as np

from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.measured.segment import Segment
from exoid.report.parts.appraisal import appraise

TIME = np.arange(101) / 100


def test_a_whole_segment_has_nothing_lost():
    found = appraise(Segment(TIME, raw_angle=np.sin(TIME)), Sensors())
    assert (found.samples, found.gaps, found.missing) == (101, 0, 0)
    np.testing.assert_allclose((found.rate, found.duration), (100.0, 1.0))


def test_steps_that_lost_a_sample_are_gaps():
    kept = np.delete(np.arange(101), [10, 50, 51])
    found = appraise(Segment(TIME[kept], raw_angle=np.sin(TIME[kept])), Sensors())
    assert found.gaps == 2
    np.testing.assert_allclose((found.longest, found.rate), (0.03, 100.0))


def test_missing_angles_are_counted():
    angle = np.where(TIME < 0.05, np.nan, TIME)
    assert appraise(Segment(TIME, raw_angle=angle), Sensors()).missing == 5


def test_a_gyro_at_the_end_of_its_range_is_saturated():
    gyro = np.radians(np.clip(np.linspace(-300, 300, 101), -250, 250))
    segment = Segment(TIME, raw_angle=TIME, raw_angular_velocity=gyro)
    assert appraise(segment, Sensors(gyro_range=250.0)).saturated == 18  # 9 at either end
    assert appraise(segment, Sensors()).saturated is None
