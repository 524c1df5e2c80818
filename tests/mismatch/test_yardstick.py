"""What a difference between sums of squares is worth."""

import numpy as np
import pytest

from exoid.mismatch.evidence.measure import long_run
from exoid.mismatch.evidence.yardstick import Yardstick

WHITE = Yardstick(samples=2000, scale=1.0)


def test_what_noise_gains_is_never_clear():
    # The largest of 30 causes with 3 parameters each, 10 000 recordings.
    gains = np.random.default_rng(0).chisquare(3, size=(10_000, 30)).max(axis=1)
    assert not any(WHITE.clear(2000.0 + float(gain), 2000.0, 3) for gain in gains)


def test_power_grows_from_that_of_noise_to_one():
    powers = [WHITE.power(2000.0 + gain, 2000.0, 1) for gain in (0, 20, 60, 200)]
    assert powers == sorted(powers)
    assert powers[0] < 1e-4
    assert powers[-1] > 0.999


def test_a_gain_that_changes_nothing_does_not_matter():
    many = Yardstick(samples=100_000, scale=1.0)
    assert many.evidence(100_100.0, 100_000.0, 1) > 30
    assert not many.clear(100_100.0, 100_000.0, 1)


@pytest.mark.parametrize("memory", [0.0, 0.8])
def test_the_long_run_variance_is_that_of_the_mean(memory):
    # An autoregression of order one, at 100 Hz: variance over (1 - memory)^2 (of its steps).
    steps = np.random.default_rng(2).normal(size=20_000)
    noise = np.zeros_like(steps)
    for k in range(1, steps.size):
        noise[k] = memory * noise[k - 1] + steps[k]
    assert long_run(noise, 0.01) == pytest.approx(1 / (1 - memory) ** 2, rel=0.25)
