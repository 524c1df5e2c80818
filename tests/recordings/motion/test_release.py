"""When a hand let go, against instants that SciPy's legs were let go at."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.signal import butter, lfilter

from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.measured.segment import Segment
from exoid.recordings.motion.extent import Motionless
from exoid.recordings.motion.find_free import find_free
from exoid.recordings.motion.signal import signal_of
from hands import ADULT, SPASTIC, Device, Hand, dropped

GYRO = Device()
ENCODER = Device(200.0, 8e-5, None)
CAMERA = Device(120.0, np.radians(0.3), None)
SLOW_CAMERA = Device(30.0, np.radians(1.0), None)
FAST = Device(1000.0, 1e-4, 3e-3)


def found(*case, **options):
    recording, release = dropped(*case, lasting=3.0, **options)
    (segment,) = recording.segments
    return find_free(signal_of(segment, recording.sensors)), release, segment.time


@pytest.mark.proof
@pytest.mark.parametrize("device", [GYRO, ENCODER, CAMERA, SLOW_CAMERA, FAST])
@pytest.mark.parametrize("knee", [ADULT, SPASTIC])
@pytest.mark.parametrize("fade", [0.02, 0.1])
def test_the_release_is_found_within_its_error_and_the_hand_is_out_of_the_fit(device, knee, fade):
    extent, release, time = found(knee, Hand(fade=fade, soft=False), device, seed=3)
    # An even fade acts like a release in its middle, but that the leg turns meanwhile: 3 ms.
    assert extent.release == pytest.approx(release + fade / 2, abs=3 * extent.release_error + 3e-3)
    assert time[extent.held_until] <= release + fade / 2
    assert time[extent.free] > release + fade - 0.005
    assert time[extent.free] < release + fade + 0.3


def test_the_error_follows_the_noise():
    sharp, rough = (found(ADULT, Hand(), each)[0].release_error for each in (GYRO, SLOW_CAMERA))
    assert sharp < 0.002
    assert 0.02 < rough < 0.15


@pytest.mark.parametrize("device", [GYRO, CAMERA])
def test_a_gyro_that_is_off_by_its_bias_is_no_movement(device):
    recording, release = dropped(ADULT, Hand(), GYRO, lasting=3.0)
    (segment,) = recording.segments
    biased = replace(segment, raw_angular_velocity=segment.raw_angular_velocity + 0.03)
    extent = find_free(signal_of(biased, recording.sensors))
    assert extent.release == pytest.approx(release + 0.025, abs=0.005)


@pytest.mark.parametrize("corner", [4.0, 6.0, 12.0])  # Hz
def test_a_gyro_behind_a_slow_filter_does_not_tell_when_it_was(corner):
    recording, release = dropped(ADULT, Hand(), GYRO, lasting=3.0)
    (segment,) = recording.segments
    low = butter(2, corner, fs=1 / np.median(np.diff(segment.time)))
    slow = replace(segment, raw_angular_velocity=lfilter(*low, segment.raw_angular_velocity))
    extent = find_free(signal_of(slow, recording.sensors))
    assert extent.release == pytest.approx(release + 0.025, abs=3 * extent.release_error + 3e-3)


@pytest.mark.parametrize("device", [GYRO, ENCODER, CAMERA])
def test_of_a_recording_that_begins_at_the_release_nothing_is_left_out(device):
    extent, _, _ = found(ADULT, Hand(hold=0.0, fade=0.0), device)
    assert (extent.held_until, extent.start, extent.free) == (None, 0, 0)


def test_of_a_recording_that_begins_in_motion_nothing_is_left_out():
    recording, release = dropped(ADULT, Hand(), CAMERA, lasting=3.0)
    (segment,) = recording.segments
    late = segment.time > release + 0.25
    cut = Segment(segment.time[late], raw_angle=segment.raw_angle[late])
    extent = find_free(signal_of(cut, recording.sensors))
    assert (extent.held_until, extent.start, extent.free) == (None, 0, 0)


def test_lost_samples_an_uneven_clock_and_spikes_do_not_move_the_release():
    recording, release = dropped(ADULT, Hand(), GYRO, lasting=3.0)
    (segment,) = recording.segments
    rng = np.random.default_rng(1)
    kept = np.sort(rng.choice(segment.time.size, segment.time.size * 9 // 10, replace=False))
    angle = segment.raw_angle[kept].copy()
    angle[rng.choice(kept.size, 15, replace=False)] = np.nan
    angle[rng.choice(kept.size, 4, replace=False)] += 0.3
    worse = Segment(
        segment.time[kept], raw_angle=angle, raw_angular_velocity=segment.raw_angular_velocity[kept]
    )
    extent = find_free(signal_of(worse, recording.sensors))
    assert extent.release == pytest.approx(release + 0.025, abs=0.006)


@pytest.mark.parametrize("noise", [1e-4, 0.02])
def test_noise_alone_is_no_movement(noise):
    """100 holds of 4 s, so less than one false movement in 33 at 95 % confidence."""
    time = np.arange(0, 4, 1 / 60)
    for seed in range(100):
        held = noise * np.random.default_rng(seed).standard_normal(time.size)
        with pytest.raises(Motionless, match="nothing moves"):
            find_free(signal_of(Segment(time, raw_angle=held - 0.3), Sensors()))
