"""A record that ends while a leg swings, or whose clock changes, is of a leg that nobody took."""

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


def test_swings_that_go_on_in_half_the_time_may_be_of_a_clock_that_changed():
    """A logger takes every other sample from 2 s on, and its stamps go on by 10 ms."""
    leg = Oscillator(decay=0.4)
    true = np.concatenate([np.arange(0.0, HOLD + 2.0, STEP), np.arange(HOLD + 2.0, 11.0, 2 * STEP)])
    time = STEP * np.arange(true.size)
    angle = leg.angle(true - HOLD) + 0.0009 * np.random.default_rng(1).normal(size=time.size)
    found = find_free(signal_of(Segment(time, raw_angle=angle), Sensors()))
    assert "its times are wrong from there on (its swings take 0.5" in found.why
    yields = np.interp(time, [0.0, HOLD + 2.0, HOLD + 2.4, 20.0], [1.0, 1.0, 0.0, 0.0])
    caught = leg.rest + (leg.angle(time - HOLD) - leg.rest) * yields + np.radians(8) * (1 - yields)
    found = find_free(signal_of(Segment(time, raw_angle=caught), Sensors()))
    assert found.ended == "caught"
    assert "times are wrong" not in found.why
