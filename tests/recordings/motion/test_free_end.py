"""Where a free motion ends: at rest, by a hand, with the recording."""

import numpy as np
import pytest

from exoid.recordings.motion.find_free import find_free
from exoid.recordings.motion.signal import signal_of
from hands import ADULT, SPASTIC, Device, Hand, Knee, dropped

GYRO = Device()
CAMERA = Device(60.0, np.radians(0.5), None)
DAMPED = Knee(damping=2.0)


def ended(knee, hand, device, lasting=8.0):
    recording, release = dropped(knee, hand, device, lasting=lasting)
    (segment,) = recording.segments
    extent = find_free(signal_of(segment, recording.sensors))
    return extent, segment.time[extent.stop - 1] - release - hand.fade, segment.time


@pytest.mark.parametrize("device", [GYRO, CAMERA])
@pytest.mark.parametrize("knee", [ADULT, SPASTIC])
def test_a_leg_that_nobody_touches_is_kept_to_its_rest_or_the_end(knee, device):
    extent, lasted, time = ended(knee, Hand(), device)
    assert extent.ended == ("recording stopped" if knee is ADULT else "at rest")
    assert extent.stop == time.size or lasted > 3.0


@pytest.mark.parametrize("device", [GYRO, CAMERA])
@pytest.mark.parametrize("after", [3.1, 3.4, 3.7, 4.0])
def test_a_hand_that_lifts_a_swinging_leg_is_left_out_with_what_it_may_have_touched(device, after):
    extent, lasted, _ = ended(ADULT, Hand(lift=after), device)
    assert extent.ended == "caught"
    assert after - 1.7 < lasted < after + 0.1  # the turning points of 1.1 s a swing bound it


@pytest.mark.parametrize("device", [GYRO, CAMERA])
@pytest.mark.parametrize("after", [2.5, 2.75, 3.0])
def test_a_hand_that_stops_a_leg_is_left_out(device, after):
    extent, lasted, _ = ended(Knee(damping=0.2), Hand(stop=after), device)
    assert extent.ended == "caught"
    assert after - 1.7 < lasted < after + 0.15


@pytest.mark.parametrize("device", [GYRO, CAMERA])
def test_of_a_leg_that_was_at_rest_before_a_hand_lifts_it_the_rest_is_kept(device):
    extent, lasted, _ = ended(SPASTIC, Hand(lift=3.0), device)
    assert extent.ended == "at rest"
    assert 2.4 < lasted < 3.05
