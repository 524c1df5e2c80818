"""A record that ends while a leg swings ends with no hand, whatever a line makes of a turn."""

import numpy as np
import pytest

from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.measured.segment import Segment
from exoid.recordings.motion.find_free import find_free
from exoid.recordings.motion.signal import signal_of
from swings import HOLD, Oscillator

CHILD = Oscillator(rest=-1.5, amplitude=1.1, frequency=6.5, decay=0.12)
STEP = 0.01  # s


@pytest.mark.parametrize("lasting", np.arange(5.0, 6.0, 0.04).round(2).tolist())
def test_a_coarse_angle_that_is_cut_in_a_swing_is_of_a_leg_that_nobody_touched(lasting):
    time = np.arange(0.0, HOLD + lasting, STEP)
    angle = np.degrees(CHILD.angle(time - HOLD))
    angle = np.radians(np.round(angle + 0.05 * np.random.default_rng(1).normal(size=time.size)))
    found = find_free(signal_of(Segment(time, raw_angle=angle), Sensors()))
    assert found.ended == "recording stopped", found.why
