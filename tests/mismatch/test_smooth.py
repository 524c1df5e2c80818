"""The motion behind the samples, without any leg model."""

import numpy as np
import pytest

from exoid.mismatch.sensors.smooth import smooth

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
