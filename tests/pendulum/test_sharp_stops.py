"""Peak accelerations of a leg that runs into a stop, which no polynomial over 0.2 s follows."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from exoid.pendulum.drops import measure_drops
from swings import recorded

HOLD, STEP, NOISE = 0.8, 0.001, np.radians(0.022) / 12**0.5  # s, s, rad of 14 bits
START = np.radians(-8.0)


def acceleration(angle, speed, width):
    """Gravity, a soft spring, damping, and a stop at -118 deg that stiffens over `width` deg."""
    stop = 1.75 * np.exp(-(angle + np.radians(118.0)) / np.radians(width))
    return -26.0 * np.cos(angle) - 4.0 * (angle + np.radians(35.0)) - 0.7 * speed + stop


def swing(width):
    """Angle [rad] and acceleration [rad/s^2] in 4 s from rest, by SciPy."""
    times = np.arange(0.0, 4.0, STEP)
    found = solve_ivp(
        lambda _, state: [state[1], acceleration(*state, width)],
        (0.0, times[-1]),
        [START, 0.0],
        t_eval=times,
        rtol=1e-9,
        atol=1e-10,
    )
    return found.y[0], acceleration(*found.y, width)


@pytest.mark.parametrize("width", [3.0, 4.0, 5.0, 7.0, 12.0])
def test_the_acceleration_at_a_stop_is_within_its_error(width):
    angle, bends = swing(width)
    every = np.concatenate([np.full(round(HOLD / STEP), START), angle])
    every = every + NOISE * np.random.default_rng(1).normal(size=every.size)
    (found,) = measure_drops(recorded(every, STEP * np.arange(every.size), noise=NOISE)).drops
    read = found.measures["peak_extension_acceleration"]
    assert read.value is not None
    assert read.standard_error is not None
    assert abs(read.value - bends.max()) < 3 * read.standard_error
    assert read.standard_error < 0.15 * read.value
