"""Value and slope around a sample, against a fit to each window alone."""

import numpy as np
import pytest

from exoid.recordings.signal.local_line import local_line

WIDTH = 0.1  # s


def fitted_alone(time, samples, width=WIDTH):
    """numpy's own line through the window of every sample, relative to that sample."""
    found = []
    for now in time:
        first, last = np.searchsorted(time, [now - width / 2, now + width / 2])
        last += int(last < time.size and time[last] == now + width / 2)
        first = min(first, max(last - 3, 0))
        last = min(max(last, first + 3), time.size)
        found.append(np.polyfit(time[first:last] - now, samples[first:last], 1)[::-1])
    return np.array(found).T


@pytest.mark.parametrize("before", [0.0, 24 * 3600.0, 365 * 24 * 3600.0])
def test_lines_are_those_of_numpy_whatever_the_clock_says(before):
    time = before + np.cumsum(np.random.default_rng(0).uniform(0.001, 0.02, 400))
    samples = np.sin(2 * time)
    # A clock of 3e7 s counts in steps of 4e-9 s, on windows of 0.1 s.
    limit = 1e-12 + 1e-6 * (before > 1e6)
    assert np.allclose(local_line(time, samples, WIDTH), fitted_alone(time, samples), atol=limit)


@pytest.mark.parametrize("gap", [1.0, 3600.0, 7 * 24 * 3600.0])
def test_a_gap_does_not_spoil_the_slopes_beside_it(gap):
    time = np.arange(600) * 0.01
    time[300:] += gap
    slope = local_line(time, np.radians(30) * np.sin(3 * time), WIDTH)[1]
    true = 3 * np.radians(30) * np.cos(3 * time)
    inner = np.arange(600) % 300
    inner = (inner >= 5) & (inner < 295)  # windows at an edge lean away from it
    # A window gains or loses a sample at its edge by rounding: half a step's turn of 4.7 rad/s^2.
    assert np.abs(slope - true)[inner].max() < 0.005 * 9 * np.radians(30) + 0.01


def test_a_leg_at_rest_has_the_slope_of_its_noise_after_a_day():
    rng = np.random.default_rng(1)
    time = 24 * 3600 + np.arange(20_000) * 0.01
    slope = local_line(time, rng.normal(0, 1e-4, time.size), WIDTH)[1]
    lags = np.arange(-5, 6) * 0.01  # of a window of 11 samples
    assert np.std(slope) == pytest.approx(1e-4 / np.sqrt(np.sum(lags**2)), rel=0.05)
