"""What only a sensor can have done is taken out of a recording, and nothing else."""

from dataclasses import replace

import numpy as np
import pytest
from test_noise import NOISE, sampled, swing

import two_bodies
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from exoid.recordings.signal.both_sensors.clean import clean
from exoid.recordings.signal.tone import find_tone, without_tone


def recording(rate=120, seed=0, add=lambda time: 0.0, **sensors):
    segments = []
    for number in range(3):
        time, angle = sampled(rate, NOISE, 10 * seed + number)
        segments.append(Segment(time, raw_angle=angle + add(time + 20 * number)))
    return Recording(tuple(segments), sensors=Sensors(**sensors))


@pytest.mark.parametrize(("rate", "seen"), [(60, 10.0), (120, 50.0), (200, 50.0)])
def test_hum_is_found_where_the_sampling_puts_it_and_taken_out(rate, seen):
    """Half the noise is hum: 1440 samples and more tell its frequency to 0.01 Hz."""
    hummed = recording(rate, add=lambda time: 0.7 * NOISE * np.sin(2 * np.pi * 50 * time + 1))
    found = clean(hummed)
    assert found.angle.tone is not None
    assert found.angle.tone.frequency == pytest.approx(seen, abs=0.01)
    assert found.angle.tone.amplitude == pytest.approx(0.7 * NOISE, rel=0.2)
    left = found.recording.segments[0]
    assert np.std(left.raw_angle - swing(left.time)) == pytest.approx(NOISE, rel=0.07)


def test_white_noise_has_no_tone():
    """One in 10,000 is allowed to."""
    found = [clean(recording(rate, seed)).angle.tone for rate in (30, 100) for seed in range(30)]
    assert found == [None] * 60


def test_a_tone_is_taken_out_of_uneven_samples_too():
    time, angle = sampled(100, NOISE, jitter=0.5)
    angle = angle + 3 * NOISE * np.sin(2 * np.pi * 30 * time)
    angle[::37] = np.nan
    tone = find_tone([time], [angle])
    assert tone is not None
    left = without_tone(time, angle, tone) - swing(time)
    assert np.nanstd(left) == pytest.approx(NOISE, rel=0.1)


def test_a_clean_recording_is_left_as_it_is():
    given = recording(angle_noise=NOISE)
    found = clean(given)
    for one, other in zip(given.segments, found.recording.segments, strict=True):
        assert np.array_equal(one.raw_angle, other.raw_angle)
    assert found.angle.level == NOISE
    assert found.angle.spikes == 0
    assert found.velocity is None


def test_spikes_become_missing_samples_and_are_counted():
    given = recording()
    angle = given.segments[1].raw_angle.copy()
    angle[200] += 1.0
    spiked = replace(
        given, segments=(given.segments[0], replace(given.segments[1], raw_angle=angle))
    )
    found = clean(spiked)
    assert found.angle.spikes == 1
    assert np.flatnonzero(np.isnan(found.recording.segments[1].raw_angle)).tolist() == [200]


def test_what_the_firmwares_filter_gave_is_left_as_it_is():
    time, angle = sampled(100, 1e-5)
    angle[100] += 1.0
    filtered = Recording((Segment(time, angle=angle, angular_velocity=angle),))
    found = clean(filtered)
    assert np.array_equal(found.recording.segments[0].angle, angle)


def test_hum_is_not_heard_in_a_frame_that_strikes():
    """With play it does so at every turn, far louder in some pieces than in others."""
    frame = two_bodies.Frame(0.0175, 0.010, 0.3, 0.15, 0.03, 400.0, 0.7)
    child, how = two_bodies.Leg(0.30, 8.5, 1.2, 0.15), two_bodies.Session()
    for seed in (0, 1):
        each = two_bodies.recorded(child, frame, how, seed).segments
        times = [one.time for one in each]
        rates = [one.raw_angular_velocity for one in each if one.raw_angular_velocity is not None]
        assert find_tone(times, rates, how.gyro_noise) is None


@pytest.mark.parametrize("value", [0.0, -3.0])
@pytest.mark.parametrize("share", [0.01, 0.05])
def test_a_value_that_a_logger_writes_for_none_is_left_out_wherever_it_stands(value, share):
    """Alone, in crowds, so often that they outnumber the leg's turns, and at both ends."""
    random, given, wild = np.random.default_rng(1), recording(rate=200), []
    for each in given.segments:
        mask = random.uniform(size=each.time.size) < share
        mask[[1, 60, 62, 64, -1]] = True
        wild.append(np.where(mask, value, each.raw_angle))
    segments = [replace(one, raw_angle=own) for one, own in zip(given.segments, wild, strict=True)]
    found = clean(replace(given, segments=tuple(segments)))
    for one, left in zip(segments, found.recording.segments, strict=True):
        assert np.array_equal(np.isnan(left.raw_angle), one.raw_angle == value)


@pytest.mark.parametrize("rate", [25, 50, 200])
@pytest.mark.parametrize("first", range(5))
def test_an_angle_that_begins_or_ends_at_any_speed_is_left_whole(rate, first):
    """Let go at the first samples, or cut as it falls."""
    time, angle = sampled(rate, NOISE / 10)
    held = np.concatenate([np.full(first, angle[0]), angle])
    time = np.arange(held.size) / rate
    for last in range(held.size - 20, held.size):
        whole = Segment(time[:last], raw_angle=held[:last])
        found = clean(Recording((whole,))).recording.segments[0]
        assert not np.isnan(found.raw_angle).any()
