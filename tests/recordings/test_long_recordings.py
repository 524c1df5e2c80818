"""Recordings of hours, and with gaps of days: what costs memory or time grows with the samples."""

import tracemalloc

import numpy as np
import pytest

from exoid.recordings.declared.subject import Subject
from exoid.recordings.loading.load import load
from exoid.recordings.measured.samples import block_means
from exoid.recordings.measured.segment import Segment
from exoid.recordings.motion.signal import Signal
from exoid.recordings.recording import Recording
from exoid.recordings.signal.both_sensors.clean import clean
from exoid.recordings.signal.tone import find_tone, motion

STEP, NOISE = 0.01, 1e-3  # s, rad
WEEK = 7 * 24 * 3600.0  # s


def swings(count, seed=0):
    """A leg that swings for ever, and the noise of its encoder."""
    time = np.arange(count) * STEP
    noise = np.random.default_rng(seed).normal(0, NOISE, count)
    return time, 0.3 * np.sin(5.7 * time) + noise


def test_a_tone_is_found_beyond_a_gap_of_a_week_in_little_memory():
    time, angle = swings(6_000)
    time[3_000:] += WEEK
    hum = 0.01 * np.sin(2 * np.pi * 20.0 * time)
    tracemalloc.start()
    found = find_tone([time], [angle + hum], NOISE)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert found is not None
    assert found.frequency == pytest.approx(20.0, abs=0.02)  # half a line of 30 s
    assert peak < 50e6  # a grid over the week would take 500 MB


def test_the_spline_that_is_the_motion_is_no_other_for_a_part_of_a_long_recording():
    time, angle = swings(50_000)
    whole = motion(time, angle)
    part = slice(4_000, 6_000)
    inner = slice(100, -100)  # from the ends of the part a knot or two reach in
    alone = motion(time[part], angle[part])
    assert np.abs(whole[part][inner] - alone[inner]).max() < 3 * NOISE
    assert np.std(whole - 0.3 * np.sin(5.7 * time)) < NOISE  # eight samples a knot share a noise


@pytest.mark.parametrize("hour", [0.0, 1.0, 24.0])
def test_the_noise_of_a_leg_at_rest_is_that_of_its_encoder_after_any_time(hour):
    time = 3600 * hour + np.arange(4_000) * STEP
    angle = np.random.default_rng(1).normal(0, NOISE, time.size)
    segment = Segment(time=time - time[0], raw_angle=angle, begins=float(time[0]))
    recording = Recording(segments=(segment,), subject=Subject(body_mass=75.0))
    # 4000 samples tell a standard deviation to 1.1 %.
    assert clean(recording).angle.level == pytest.approx(NOISE, rel=0.05)


def test_means_of_blocks_are_of_what_is_known():
    samples = np.array([1.0, 3.0, np.nan, 5.0, np.nan, np.nan, 7.0])
    assert np.array_equal(block_means(samples, 2), [2.0, 5.0, np.nan], equal_nan=True)
    assert block_means(samples, 1) is samples


def test_a_signal_that_is_averaged_has_less_noise_at_the_same_times():
    time, angle = swings(9_000)
    signal = Signal(time / 10, angle, NOISE, None, np.inf)  # at 1 kHz
    mean = signal.averaged(0.003)
    assert mean.time.size == 3_000
    assert mean.angle_noise == pytest.approx(NOISE / np.sqrt(3))
    assert np.array_equal(mean.time, (time / 10).reshape(-1, 3).mean(axis=1))


def fast(rate, tmp_path):
    """A drop at so many samples a second, as a table."""
    time = np.arange(0, 4, 1 / rate)
    since = np.maximum(time - 0.5, 0)
    angle = -1.25 + 1.25 * np.exp(-0.5 * since) * np.cos(5.7 * since)
    angle = angle + np.random.default_rng(2).normal(0, NOISE, time.size)
    path = tmp_path / f"{rate}.csv"
    table = np.column_stack([time, angle])
    np.savetxt(path, table, delimiter=",", header="time_s,angle_rad", comments="", fmt="%.9g")
    return path


def test_what_is_sampled_faster_than_a_leg_moves_is_averaged_and_said(tmp_path):
    path = fast(20_000, tmp_path)
    loaded = load(path)
    (segment,) = loaded.recording.segments
    assert np.median(np.diff(segment.time)) == pytest.approx(1e-3)
    assert any("means over 20 samples" in each for each in loaded.notes)
    assert load(path, whole=True).recording.segments[0].time.size == 80_000
    # 4000 samples tell a standard deviation to 1.1 %.
    assert clean(loaded.recording).angle.level == pytest.approx(NOISE / np.sqrt(20), rel=0.05)


def test_a_thousand_samples_a_second_are_used_as_they_are(tmp_path):
    loaded = load(fast(1_000, tmp_path))
    assert loaded.recording.segments[0].time.size == 4_000
    assert not any("means over" in each for each in loaded.notes)
