"""A zero that slips between drops, or creeps in each: the seat is held level, and the leg bends."""

from dataclasses import replace

import numpy as np
import pytest

from exoid.fitting.estimate import fit
from legs import ADULT, drop, recording

STARTS = (-0.2, -0.5, 0.0, -0.35)  # rad
WITHIN = 3.3  # standard errors: one in a thousand by chance is farther off


def off(slips, creep=0.0):
    """(estimate - truth) / standard error of m l g / J and c / J, and the errors."""
    drops = [drop(start=start, seed=seed) for seed, start in enumerate(STARTS)]
    slipped = [
        replace(one, raw_angle=one.best_angle + np.radians(slip + creep * one.time))
        for one, slip in zip(drops, slips, strict=True)
    ]
    ratios = fit(recording(*slipped), multistart=2).ratios
    truth = dict(zip(("gravity", "stiffness"), ADULT, strict=False))
    each = {name: ratios[f"{name}_over_inertia"] for name in truth}
    found = np.array([each[name].value for name in truth], dtype=float)
    errors = np.array([each[name].standard_error for name in truth], dtype=float)
    return np.abs(found - list(truth.values())) / errors, errors


@pytest.mark.parametrize(
    ("slips", "creep"), [((0, 2, 2, -1), 0.0), ((0, -2, 1, 1), 0.0), ((0, 0, 0, 0), 0.15)]
)
def test_a_zero_that_moves_is_within_the_errors(slips, creep):
    """Slips in degrees, creep in degrees a second."""
    away, _ = off(slips, creep)
    assert away.max() < WITHIN


def test_errors_of_a_zero_that_stays_are_as_small_as_ever():
    away, errors = off((0, 0, 0, 0))
    assert away.max() < WITHIN
    assert errors.max() < 0.1  # 1/s^2; a slip by two degrees makes them several times as large
