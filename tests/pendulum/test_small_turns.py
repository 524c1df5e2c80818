"""When a leg turns around whose swing is hardly more than the noise, or than a step of its encoder:
such an angle bends by its errors, and a place between them seems surer than it is.
"""

import numpy as np
import pytest

from exoid.pendulum.drops import measure_drops
from exoid.recordings.landmarks.peak import bends_of
from exoid.recordings.landmarks.track import Peak
from swings import HOLD, Oscillator, recorded

STIFF = Oscillator(decay=1.3, frequency=6.5)
SPASTIC = Oscillator(decay=1.6, frequency=6.5)
SLOW, QUICK = 1 / 50, 1 / 250  # s
NOISE, WHOLE = np.radians(0.8), np.radians(1.0)  # rad
RUN = 6


def off(angle, time, leg):
    """By how many errors, of the drop's own, the period is."""
    found = measure_drops(recorded(angle, time, noise=None)).drops[0].measures["period"]
    assert found.value is not None, found.reason
    return (found.value - leg.period) / found.standard_error


def test_the_period_of_a_leg_that_hardly_swings_holds_what_noise_does_to_its_turns():
    time = np.arange(0, HOLD + 8.0, SLOW)
    noise = (np.random.default_rng(seed).normal(size=time.size) for seed in range(RUN))
    found = [off(STIFF.angle(time - HOLD) + NOISE * each, time, STIFF) for each in noise]
    assert np.abs(found).max() < 3.2  # of 6, once in 100


def test_the_period_of_a_leg_that_turns_within_one_code_holds_where_in_it_that_may_be():
    time = np.arange(0, HOLD + 8.0, QUICK)
    codes = (WHOLE * each / RUN for each in range(RUN))
    turned = (SPASTIC.angle(time - HOLD) + each for each in codes)
    found = [off(WHOLE * np.round(each / WHOLE), time, SPASTIC) for each in turned]
    assert np.abs(found).max() < 3.0


def test_a_swing_bends_at_its_turns_as_it_would_in_an_equation_of_motion():
    leg = STIFF
    half = leg.period / 2
    values = [leg.angle(np.array([half * n]))[0] for n in (1, 2, 3, 4)]
    turns = [
        Peak(0, half * n, 0.0, value, 0.0) for n, value in zip((1, 2, 3, 4), values, strict=True)
    ]
    expected = [-leg.pull * (value - leg.rest) for value in values]
    assert bends_of(turns) == pytest.approx(expected, rel=1e-9)
    assert bends_of(turns[:1]) is None
