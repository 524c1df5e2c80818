"""A gyro's wandering zero is told from every other error of the sensors."""

import tracemalloc

import numpy as np
import pytest

from exoid.recordings.signal.both_sensors.gyro_drift import gyro_drift

ANGLE, RATE = 0.0008, 0.005  # noise, rad and rad/s
TIME = np.arange(0, 8, 0.01)
FREQUENCY, DECAY = 2 * np.pi * 0.95, 0.3


def angle_at(time):
    return -1.2 + np.exp(-DECAY * time) * np.cos(FREQUENCY * time)


def rate_at(time):
    turn = FREQUENCY * np.sin(FREQUENCY * time) + DECAY * np.cos(FREQUENCY * time)
    return -np.exp(-DECAY * time) * turn


def told(zero, seed=0, *, scale=1.0, late=0.0, eccentric=0.0, base=0.0, segments=3):
    """The drift that is found where the gyro's zero is `zero` [rad/s]."""
    generator = np.random.default_rng(seed)
    shown = angle_at(TIME)
    angles, rates = [], []
    for _ in range(segments):
        angle = shown + eccentric * np.sin(shown + 1.0) + ANGLE * generator.normal(size=TIME.size)
        rate = scale * rate_at(TIME - late) + base * np.sin(8.0 * TIME) + zero
        angles.append(angle)
        rates.append(rate + RATE * generator.normal(size=TIME.size))
    return gyro_drift([TIME] * segments, angles, rates, (ANGLE, RATE))


def test_a_zero_that_wanders_is_told_beside_other_errors_of_the_sensors():
    """A window of 50 samples tells 0.0014 rad/s, a knot of five windows 0.001."""
    zero = np.radians(0.8) * np.sin(2 * np.pi * TIME / 16)
    found = told(zero)
    assert found is not None
    inner = (TIME > 1) & (TIME < 7)  # first swing and end are told by one side alone
    for each in found:
        assert each[inner] == pytest.approx((zero - zero.mean())[inner], abs=0.005)
    faulty = told(zero, scale=1.02, late=0.005, eccentric=0.01)
    assert faulty is not None
    for each in faulty:  # the first swings, and the magnet, are slow in part, too
        assert np.std(each - zero) < 0.7 * np.std(zero)


def test_a_steady_zero_does_not_wander_whatever_else_is_wrong():
    """One in 10,000 is allowed to."""
    for seed in range(30):
        assert told(0.03, seed, scale=0.97, late=0.008, eccentric=0.02) is None


def test_a_late_gyro_does_not_wander_where_a_leg_is_let_go():
    """Half the square of 25 ms times the acceleration of a fall is 0.6 deg/s."""
    angle_noise, rate_noise, held, late = 4e-4, 2e-3, 0.4, 0.025
    free = np.maximum(TIME - held, 0.0)
    before = np.maximum(TIME - held - late, 0.0)
    for seed in range(10):
        generator = np.random.default_rng(seed)
        angles = [angle_at(free) + angle_noise * generator.normal(size=TIME.size)] * 4
        shown = np.where(before > 0, rate_at(before), 0.0)
        rates = [shown + 0.01 + rate_noise * generator.normal(size=TIME.size) for _ in range(4)]
        assert gyro_drift([TIME] * 4, angles, rates, (angle_noise, rate_noise)) is None


def test_a_mismatch_that_no_drift_explains_is_left_alone():
    """A thigh that swings moves the gyro, not the encoder."""
    assert told(0.0, base=0.3) is None


def test_one_short_segment_cannot_wander():
    few = slice(0, 40)
    assert (
        gyro_drift([TIME[few]], [angle_at(TIME)[few]], [rate_at(TIME)[few]], (ANGLE, RATE)) is None
    )


def test_many_segments_take_memory_as_many_times_as_few():
    """A table of the zeros of all by the windows of all would take sixteen times as much."""
    peaks = []
    for segments in (50, 200):
        tracemalloc.start()
        before = tracemalloc.get_traced_memory()[0]
        told(np.zeros(TIME.size), segments=segments)
        peaks.append(tracemalloc.get_traced_memory()[1] - before)
        tracemalloc.stop()
    assert peaks[1] < 1.2 * 4 * peaks[0]


def test_two_loggers_whose_samples_never_fall_on_one_time_tell_no_drift():
    by_turns = np.arange(TIME.size) % 2 == 0
    angle = np.where(by_turns, angle_at(TIME), np.nan)
    rate = np.where(by_turns, np.nan, rate_at(TIME))
    assert gyro_drift([TIME], [angle], [rate], (ANGLE, RATE)) is None
