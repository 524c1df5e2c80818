"""The motion behind the samples, without any leg model."""

import numpy as np
import pytest

from exoid.mismatch.sensors.compare import compare
from exoid.mismatch.sensors.faults import ECCENTRIC, SCALE
from exoid.mismatch.sensors.smooth import smooth
from exoid.mismatch.sensors.strikes import strikes

ANGLE, RATE = 7e-4, 3e-3  # rad, rad/s: noise of the sensors


def swing(seed=0, gyro=True, step=0.01):
    """phi = -1.2 + 0.8 exp(-t/3) sin(5 t), as encoder and gyro show it."""
    time = np.arange(0, 5, step)
    decay = 0.8 * np.exp(-time / 3)
    angle = -1.2 + decay * np.sin(5 * time)
    rate = decay * (5 * np.cos(5 * time) - np.sin(5 * time) / 3)
    slope = decay * (-25 * np.sin(5 * time) - 10 / 3 * np.cos(5 * time) + np.sin(5 * time) / 9)
    rng = np.random.default_rng(seed)
    data = np.stack([angle, rate], axis=1) + rng.normal(size=(time.size, 2)) * [ANGLE, RATE]
    weights = np.ones_like(data) / [ANGLE, RATE] * [1.0, float(gyro)]
    return time, data, weights, np.stack([angle, rate, slope], axis=1)


@pytest.mark.parametrize("gyro", [True, False])
def test_the_smoothed_motion_lies_nearer_to_the_truth_than_the_samples(gyro):
    time, data, weights, truth = swing(gyro=gyro)
    found = smooth(time, data, weights)
    assert np.std(found.angle - truth[:, 0]) < 0.6 * ANGLE
    if gyro:
        assert np.std(found.angular_velocity - truth[:, 1]) < RATE


@pytest.mark.parametrize("width", [1, 10])
def test_the_error_of_the_acceleration_is_not_larger_than_it_says(width):
    # Inner samples; at the ends fewer neighbours help. One jerk serves all of a decaying swing, so
    # that it is too large for most of it, and the error smaller than it says.
    left, said = [], []
    for seed in range(20):
        time, data, weights, truth = swing(seed)
        found = smooth(time, data, weights)
        error = (found.angular_acceleration - truth[:, 2])[20:-20]
        left.append(np.convolve(error, np.ones(width) / width, "valid"))
        said.append(found.smoother.spread(width))
    assert 0.4 < np.std(np.concatenate(left)) / np.mean(said) < 1.0


@pytest.mark.parametrize("gyro", [True, False])
def test_beyond_the_unsure_ends_the_acceleration_is_as_sure_as_in_the_middle(gyro):
    width, (time, data, weights, _) = 10, swing(gyro=gyro)
    smoother = smooth(time, data, weights).smoother
    unsure, inside = smoother.unsure(width), smoother.spread(width)
    first, kept, last = smoother.spreads([0, unsure, time.size - unsure - width], width)
    assert unsure < time.size // 3
    if not gyro:  # its rate leaves nothing unsure
        assert unsure > 0
        assert first > 2 * inside
    assert max(kept, last) < 1.6 * inside  # 1.5, and the other end rounded


def test_a_missing_stretch_of_samples_is_bridged():
    time, data, weights, truth = swing()
    weights[100:110] = 0.0
    data[100:110] = np.pi
    found = smooth(time, data, weights)
    # A tenth of a second at 20 rad/s^2 is bridged to a few hundredths of a radian.
    assert np.abs(found.angle - truth[:, 0]).max() < 0.02


def test_uneven_steps_do_no_harm():
    time, data, weights, truth = swing(step=0.004)
    kept = np.random.default_rng(1).random(time.size) < 0.5
    found = smooth(time[kept], data[kept], weights[kept])
    assert np.std(found.angle - truth[kept, 0]) < 0.6 * ANGLE


@pytest.mark.parametrize("step", [0.0025, 0.00125, 0.001], ids=["400 Hz", "800 Hz", "1 kHz"])
def test_more_samples_of_a_motion_show_it_better(step):
    """Half as far off as by a quarter as many, were it not for rounding at the highest rate."""
    time, data, weights, truth = swing(step=step)
    every = smooth(time, data, weights)
    fewer = smooth(time[::4], data[::4], weights[::4])
    error = np.std(every.angle - truth[:, 0])
    assert error < 0.8 * np.std(fewer.angle - truth[::4, 0])
    assert np.std(every.angular_acceleration - truth[:, 2]) < 0.5


def test_a_step_that_is_much_shorter_than_others_is_no_end():
    time, data, weights, _ = swing(step=0.0025)
    late = np.arange(time.size) % 7 == 0
    found = smooth(time + 0.0024 * late, data, weights)
    assert np.isfinite(found.likelihood)


def struck(seed=0, scale=0.0):
    """A fall at 20 rad/s^2 onto a stop at -1.4 rad, again and again, each time half as fast: every
    strike is between two samples.
    """
    time = np.arange(0, 2, 0.01)
    angle, rate, at, speed, before = [], [], -0.4, 0.0, 0.0
    strikes_at = []
    for now in time:
        left = now - before
        while left > 0:
            fall = (speed + np.sqrt(speed**2 + 40 * (at + 1.4))) / 20
            if fall > left:
                at, speed, left = at + speed * left - 10 * left**2, speed - 20 * left, 0.0
            else:
                at, speed, left = -1.4, 0.5 * np.sqrt(speed**2 + 40 * (at + 1.4)), left - fall
                strikes_at.append(len(angle) - 1)
            if speed < 0.3 and at <= -1.4 + 1e-12:
                speed, left, at = 0.0, 0.0, -1.4
        before = now
        angle.append(at)
        rate.append(speed)
        if speed == 0.0 and at == -1.4:
            break
    time = time[: len(angle)]
    noise = np.random.default_rng(seed).normal(size=(time.size, 2)) * [ANGLE, RATE]
    data = np.stack([angle, (1 + scale) * np.array(rate)], axis=1) + noise
    return time, data, np.ones_like(data) / [ANGLE, RATE], strikes_at


def test_a_strike_between_two_samples_is_seen_and_nothing_else():
    time, data, weights, at = struck()
    found = np.flatnonzero(strikes(time, data, weights))
    early = [one for one in at if one < time.size - 10]  # before they follow each other quickly
    assert set(early) <= set(found)
    assert all(min(abs(np.array(at) - one)) <= 2 for one in found)
    assert not strikes(*swing()[:3]).any()


def test_what_a_strike_does_between_samples_is_no_error_of_the_encoder():
    segments = [struck(seed, scale=-0.014)[:3] for seed in range(4)]
    found = compare(segments, [strikes(*each) for each in segments], (SCALE, ECCENTRIC))
    for one, true in ((SCALE, [-0.014]), (ECCENTRIC, [0.0, 0.0])):
        places = found.places((one,))
        errors = np.sqrt(np.diag(found.covariance)[places])
        assert (np.abs(found.values[places] - true) < 4 * errors).all(), one.name
