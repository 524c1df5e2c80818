"""Damping of another law than Eq. 9's leaves little; that is told, and ± holds what it moves."""

import re

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import exoid
from exoid.fitting import estimate

GRAVITY, STIFFNESS, DAMPING = 26.5, 4.0, 0.5  # over J
NOISE = np.radians([0.05, 0.15])  # rad, rad/s
LONG = 8.0  # s
RELAXING = 0.13  # s


def drops(friction: float, drag: float, tissue: float = 0.0) -> exoid.Recording:
    """Three drops of a leg with F_c / J [1/s^2], b / J [1/rad] and k_1 / J [1/s^2] of tissue that
    relaxes beside Eq. 9.
    """

    def pull(_, state):
        angle, rate, lag = state
        law = friction * np.tanh(rate / 2e-3) + drag * rate * abs(rate) + tissue * lag
        falls = -GRAVITY * np.cos(angle) - STIFFNESS * angle - DAMPING * rate - law
        return [rate, falls, rate - lag / RELAXING]

    time, random = np.arange(0.0, LONG, 0.01), np.random.default_rng(3)
    segments = []
    for start in (-0.2, -0.5, -0.35):
        begin = [start, 0.0, 0.0]
        leg = solve_ivp(pull, (0, LONG), begin, "LSODA", time, rtol=1e-9, max_step=0.01)
        angle, rate = leg.y[:2] + NOISE[:, None] * random.normal(size=(2, time.size))
        segments.append(exoid.Segment(time, raw_angle=angle, raw_angular_velocity=rate))
    return exoid.Recording(tuple(segments))


def told(result: exoid.FitResult) -> list[str]:
    return [note for note in result.notes if "most of what is missed is as" in note]


@pytest.mark.parametrize(
    ("friction", "drag", "term"),
    [(0.015, 0.0, "coulomb_friction"), (0.0, 0.004, "quadratic_drag")],
)
def test_numbers_are_within_their_errors_and_where_it_says_with_the_law(friction, drag, term):
    result = exoid.fit(drops(friction, drag), multistart=2)
    damping = result.ratios["damping_over_inertia"]
    off = abs(damping.value - DAMPING)
    assert off > 0.004  # by which Eq. 9 alone errs
    assert off < 1.5 * damping.standard_error
    (note,) = told(result)
    assert f"--with {term}" in note
    size, with_law = (float(each) for each in re.findall(r"(?:J =|would be) ([0-9.e-]+)", note))
    assert size == pytest.approx(friction or drag, rel=0.1)
    assert with_law == pytest.approx(DAMPING, abs=0.1 * off)
    fitted = exoid.fit(drops(friction, drag), multistart=2, terms=(term,))
    assert told(fitted) == []
    assert fitted.ratios["damping_over_inertia"].value == pytest.approx(with_law, abs=0.1 * off)


def test_numbers_are_within_their_errors_where_tissue_relaxes(monkeypatch):
    """Its element is a spring to quick swings and a damper to slow ones: Eq. 9 has both. Swings
    without their fall, as of a leg in a hand, would fit to the noise with that damping.
    """

    def in_a_hand(*_, **__):
        raise AssertionError("a hand was looked for")

    monkeypatch.setattr(estimate, "without_slow_release", in_a_hand)
    result = exoid.fit(drops(0.0, 0.0, tissue=2.0), multistart=2)
    for name, true in (("damping", DAMPING), ("stiffness", STIFFNESS), ("gravity", GRAVITY)):
        found = result.ratios[f"{name}_over_inertia"]
        assert abs(found.value - true) < 2 * found.standard_error
    damping = result.ratios["damping_over_inertia"]
    assert damping.value - DAMPING > 0.1  # by which Eq. 9 alone errs
    assert damping.standard_error < 0.4
    (note,) = told(result)
    assert "--with maxwell_element" in note
    assert "t_r = 0.14 s" in note
    size, with_law = (float(each) for each in re.findall(r"(?:J =|would be) ([0-9.e-]+)", note))
    assert size == pytest.approx(2.0, rel=0.5)
    assert abs(with_law - DAMPING) < 0.7 * (damping.value - DAMPING)


def test_of_a_leg_that_obeys_nothing_is_said():
    result = exoid.fit(drops(0.0, 0.0), multistart=2)
    assert told(result) == []
    assert result.ratios["damping_over_inertia"].standard_error < 1e-3 * DAMPING
