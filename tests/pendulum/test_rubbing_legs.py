"""A leg that dry friction slows down turns around at other instants than a polynomial through its
turns does.
"""

import numpy as np
import pytest

from exoid.pendulum.drops import measure_drops
from swings import NOISE, Oscillator, recorded

REST, RATE = -1.25, 5.6  # rad, rad/s


def rubbing(time, start, band):
    """Half swings about either end of a band of friction [rad]: each lasts pi / RATE exactly."""
    half = np.floor(np.maximum(time, 0.0) * RATE / np.pi)
    last = np.ceil((start - band) / (2 * band))
    way = np.where(half % 2 == 0, 1.0, -1.0)
    size = start - band - 2 * band * np.minimum(half, last)
    swings = way * band + size * np.cos(RATE * np.maximum(time, 0.0))
    return REST + np.where(half >= last, (-1.0) ** last * (start - 2 * band * last), swings)


def period(angle, time):
    (found,) = measure_drops(recorded(angle, time)).drops
    read = found.measures["period"]
    assert read.value is not None
    assert read.standard_error is not None
    return read.value, read.standard_error


@pytest.mark.parametrize("step", [0.01, 0.02])
@pytest.mark.parametrize("start", [0.3, 0.55, 0.8])
def test_the_period_of_a_leg_that_rubs_lies_within_its_error(step, start):
    """It was told up to 0.02 s too long, three to nine times its error."""
    off = []
    for seed in range(8):
        draw = np.random.default_rng(seed)
        time = np.arange(0.0, 9.0, step)
        angle = rubbing(time - 1.2 - draw.uniform(0, step), start, draw.uniform(0.02, 0.035))
        value, error = period(angle + NOISE * draw.normal(size=time.size), time)
        off.append((value - 2 * np.pi / RATE) / error)
    assert np.sqrt(np.mean(np.square(off))) < 1.7  # of 8, once in 300
    assert abs(np.mean(off)) < 1.1  # three of its errors


def test_a_leg_without_friction_keeps_its_period():
    off = []
    for seed in range(12):
        draw = np.random.default_rng(seed)
        time = np.arange(0.0, 12.0, 0.01)
        leg = Oscillator(frequency=draw.uniform(5, 6.5), decay=draw.uniform(0.3, 0.9))
        value, error = period(leg.angle(time - 1.2) + NOISE * draw.normal(size=time.size), time)
        off.append((value - leg.period) / error)
        assert error < 0.002
    assert np.sqrt(np.mean(np.square(off))) < 1.6
