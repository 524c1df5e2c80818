"""The node's filter learns the bias of its gyro, and loses nothing where there is none."""

import numpy as np
import pytest

from exoid.recordings.filter.constants import OF_NODE, UNBIASED
from exoid.recordings.filter.kalman import filter

STEP = 0.01  # s
COUNT = 2 * np.pi / 4096  # rad


def node_readings(bias, seed=0, seconds=30):
    """Two seconds of rest and a swing of 0.5 rad at 1 Hz, by encoder and gyro, and the truth."""
    time = np.arange(0, seconds, STEP)
    phase = 2 * np.pi * np.maximum(time - 2, 0)
    moves = time > 2
    angle = -0.7 + 0.5 * np.cos(phase)
    velocity = np.where(moves, -np.pi * np.sin(phase), 0)
    rng = np.random.default_rng(seed)
    counts = np.rint((angle + rng.normal(0, 7.5e-4, time.size)) / COUNT)
    gyro = velocity + bias + rng.normal(0, 2.5e-3, time.size)  # of 833 Hz
    return time, angle, velocity, counts * COUNT, gyro


def velocity_error(bias, design):
    time, _, velocity, encoder, gyro = node_readings(bias)
    state = np.asarray(filter(np.diff(time), encoder, gyro, design).state)
    return (state[:, 1] - velocity)[time > 1]


def rms(values):
    return np.sqrt(np.mean(np.square(values)))


def test_a_bias_of_the_gyro_is_no_longer_in_the_velocity():
    before, after = (velocity_error(0.05, design) for design in (UNBIASED, OF_NODE))
    print(f"rms of the velocity with a bias: {rms(before):.5f} -> {rms(after):.5f} rad/s")
    assert before.mean() == pytest.approx(0.05, rel=0.02)
    assert abs(after.mean()) < 3e-4  # the bias walks by as much as the filter thinks it can
    assert rms(after) < 0.003  # the gyro's own noise is 2.5 mrad/s


def test_without_a_bias_nothing_is_lost():
    before, after = (velocity_error(0.0, design) for design in (UNBIASED, OF_NODE))
    print(f"rms of the velocity without a bias: {rms(before):.5f} -> {rms(after):.5f} rad/s")
    assert rms(after) < 1.01 * rms(before)


@pytest.mark.parametrize("bias", [-0.17, 0.0, 0.05, 0.17])
def test_a_bias_within_the_data_sheet_is_known_half_a_second_after_the_start(bias):
    """To 2 mrad/s, the noise of one sample of the gyro, from rest or from motion."""
    for first in (0.0, 2.3, 2.6):
        time, _, _, encoder, gyro = node_readings(bias, seed=1)
        begun = time >= first
        found = filter(np.diff(time[begun]), encoder[begun], gyro[begun])
        wrong = np.abs(np.asarray(found.bias) - bias)
        assert (wrong[round(0.5 / STEP) :] < 2e-3).all()
