"""A leg that meets a stop turns around within a sample or two: no polynomial follows it."""

import numpy as np
import pytest

from exoid.pendulum.drops import measure_drops
from exoid.recordings.signal.spikes import find_spikes
from reflexes import CHILD, thrown
from swings import Oscillator, drop, recorded

FINE, HOLD = 2e-4, 0.8  # s
START, STOP = np.radians(-12.0), np.radians(-95.0)


def swing(rebound, stiffness, damping):
    """A leg above a stop at -95 deg, in steps that are short enough: one that throws it back with a
    share of its speed, else one that yields.
    """
    angle, speed = [START], 0.0
    for _ in range(round(8.0 / FINE)):
        at = angle[-1]
        pull = -26.5 * np.cos(at) - 2.7 * at - 0.7 * speed
        if at < STOP:
            pull += max(stiffness * (STOP - at) - damping * speed, 0.0)
        speed += FINE * pull
        at += FINE * speed
        if rebound and at < STOP and speed < 0:
            at, speed = STOP, -rebound * speed
        angle.append(at)
    return np.array(angle)


def read(angle, rate, noise):
    time = np.arange(0.0, HOLD + 8.0, 1 / rate)
    since = np.maximum(time - HOLD - 0.0037, 0.0)  # a stop is met between two samples
    sampled = angle[np.round(since / FINE).astype(int)]
    sampled = sampled + noise * np.random.default_rng(3).normal(size=time.size)
    (found,) = measure_drops(recorded(sampled, time, noise=noise)).drops
    return found


@pytest.mark.parametrize("rate", [50.0, 100.0, 200.0])
@pytest.mark.parametrize(
    ("rebound", "stiffness", "damping"),
    [(0.35, 0.0, 0.0), (0.0, 5000.0, 40.0), (0.0, 1000.0, 7.0)],
    ids=["hard", "within 50 ms", "within 100 ms"],
)
def test_amplitude_and_index_of_a_leg_that_meets_a_stop_are_within_their_errors(
    rate, rebound, stiffness, damping
):
    angle = swing(rebound, stiffness, damping)
    found = read(angle, rate, np.radians(0.06))
    lowest = angle[: round(1.2 / FINE)].min()
    swung = found.measures["first_flexion_amplitude"]
    assert swung.value is not None
    assert swung.standard_error is not None
    assert abs(swung.value - (START - lowest)) < 3 * swung.standard_error
    assert swung.standard_error < np.radians(0.5)
    assert "left out" not in (found.note or "")


@pytest.mark.parametrize("rate", [100.0, 200.0, 500.0])
@pytest.mark.parametrize(("stiffness", "damping"), [(5000.0, 40.0), (2000.0, 14.0), (1000.0, 7.0)])
def test_the_acceleration_at_a_stop_is_that_of_its_push(rate, stiffness, damping):
    """Polynomials over 0.2 s find a third of it to two thirds, three errors too little."""
    angle = swing(0.0, stiffness, damping)
    found = read(angle, rate, np.radians(0.06)).measures["peak_extension_acceleration"]
    greatest = np.gradient(np.gradient(angle, FINE), FINE)[: round(1.2 / FINE)].max()
    assert found.value is not None
    assert found.standard_error is not None
    assert abs(found.value - greatest) < 2 * found.standard_error
    assert found.standard_error < 0.4 * found.value


def test_a_stop_is_said_with_its_angle_and_a_reflex_is_none():
    hard = read(swing(0.35, 0.0, 0.0), 100.0, np.radians(0.06))
    assert hard.note is not None
    assert "turns around at -95 deg within 0.01 s" in hard.note
    assert hard.halt is None
    (thrown_up,) = measure_drops(recorded_reflex()).drops
    assert "something hard" not in (thrown_up.note or "")
    (free,) = measure_drops(drop(Oscillator(), noise=0.0009)).drops
    assert free.note is None


def recorded_reflex():
    segment = thrown(CHILD, 1.5, 100.0)
    return recorded(segment.best_angle, segment.time)


@pytest.mark.parametrize("at", [2.0, 2.001, 2.003, 2.005, 2.008])  # s, between samples too
@pytest.mark.parametrize("back", [0.6, 1.5, 3.0])  # rad/s
def test_the_sharp_peak_of_an_angle_is_no_spike_and_one_that_is_thrown_aside_is(at, back):
    time = np.arange(0.0, 4.0, 0.01)
    angle = np.where(time < at, -4.0 * (time - at), back * (time - at))  # rad
    angle = angle + 0.001 * np.random.default_rng(1).normal(size=time.size)
    assert not find_spikes(time, angle).any()
    spiked = angle.copy()
    spiked[[150, 260]] += 0.05
    assert np.flatnonzero(find_spikes(time, spiked)).tolist() == [150, 260]
