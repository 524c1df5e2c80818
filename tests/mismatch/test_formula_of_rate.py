"""A torque that grows with the rate up to some rate is told as that; motions by SciPy."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from exoid.mismatch.evidence.locate import averaged
from exoid.mismatch.evidence.location import Missing
from exoid.mismatch.novel.formula import Formula
from exoid.mismatch.novel.sparse_regression import formulas_beside

WIDTH, INERTIA = 5, 0.45  # samples over which a torque is averaged; kg m^2


def lacking(law, start: float, seed: int) -> Missing:
    """What Eq. 9 lacks along a drop of a leg with this torque [N m] of the rate [rad/s]."""

    def slope(_, state):
        angle, speed = state
        pull = 27.0 * np.cos(angle) + 4.0 * angle + 0.8 * speed
        return speed, law(speed) / INERTIA - pull

    time, random = np.arange(0.0, 5.0, 0.01), np.random.default_rng(seed)
    angle, speed = solve_ivp(
        slope, (0.0, 5.0), (start, 0.0), method="LSODA", t_eval=time, rtol=1e-7, atol=1e-8
    ).y
    torque = averaged(law(speed) + 0.15 * random.standard_normal(time.size), WIDTH)
    return Missing(str(seed), time, angle, speed, torque, 0.03, None, WIDTH)


def formula_of(law) -> Formula:
    rows = [lacking(law, start, seed) for seed, start in enumerate((-0.4, -0.2, -0.1))]
    legs = [(np.cos(one.angle), one.angle, one.angular_velocity) for one in rows]
    known = [np.stack([averaged(each, WIDTH) for each in leg], axis=1) for leg in legs]
    return formulas_beside(np.concatenate(known), rows)[-1]


@pytest.mark.parametrize("rate", [0.4, 0.8, 1.5])
def test_damping_that_saturates_is_told_with_the_rate_at_which_it_does(rate):
    """Not as friction beside drag, or beside damping that changes with time."""
    found = formula_of(lambda speed: -0.5 * np.tanh(speed / rate))
    (feature,) = found.features
    assert found.words.endswith(" rad/s) N m")
    assert feature.family.words == "tanh(v/{0})"
    assert feature.shape[0] == pytest.approx(rate, rel=0.1)
    assert found.coefficients[0] == pytest.approx(-0.5, rel=0.1)


def test_friction_and_damping_that_grow_are_none_that_saturates():
    assert formula_of(lambda speed: -0.2 * np.tanh(speed / 3e-3)).words.endswith(" sgn(v) N m")
    assert formula_of(lambda speed: -0.1 * speed * np.abs(speed)).words.endswith(" v|v| N m")
