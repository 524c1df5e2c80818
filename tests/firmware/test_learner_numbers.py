"""What the learner computes without a library, and what it believes of a leg before it moves."""

import numpy as np
import pytest
from float32_learned import LEVEL, STIFFNESS, UPRIGHT, learned
from float32_movement import Kept
from float32_sine import F, root, turned
from simulated_legs import Legs

import exoid
from exoid.physics.leg import GRAVITY
from exoid.recordings.filter.learning import LEARNING, UNKNOWNS


def test_sine_and_cosine_are_right_to_the_last_digits():
    angle = np.linspace(-7, 7, 200_001).astype(F)
    for found, exact in zip(turned(angle), (np.sin, np.cos), strict=True):
        off = np.abs(found - exact(angle.astype(float)))
        assert off.max() < 1.2e-7 + 4e-7 * 7 / 6.3  # an ulp of 1, and of a turn that is taken off


def test_the_root_is_right_to_six_digits_and_zero_of_what_has_none():
    square = (10 ** np.linspace(-30, 30, 100_001)).astype(F)
    assert np.max(np.abs(root(square) / np.sqrt(square.astype(float)) - 1)) < 6e-7
    assert root(np.array([0.0, -1.0, np.nan], F)).tolist() == [0.0, 0.0, 0.0]


@pytest.mark.parametrize(
    ("mass", "height"),
    [(23.0, 1.2), (32.0, 1.35), (45.0, 1.5), (77.0, 1.8), (110.0, 1.85), (95.0, 2.0)],
)
def test_what_is_believed_at_first_holds_the_legs_of_children_and_adults(mass, height):
    """Within one and a half standard deviations, each a fifth of gravity and more."""
    leg = exoid.expected_leg(mass, height)
    inertia = leg.inertia.value
    expected = {
        "level_gravity": leg.mass.value * leg.com_distance.value * GRAVITY / inertia,
        "stiffness": leg.stiffness.value / inertia,
        "damping": leg.damping.value / inertia,
    }
    for name, value in expected.items():
        at = UNKNOWNS.index(name)
        assert abs(value - LEARNING.expected[at]) < 1.5 * LEARNING.scatter[at], name
        assert LEARNING.scatter[at] > 0.19 * value, name


def test_an_encoder_that_is_five_degrees_off_is_within_what_is_believed():
    upright = UNKNOWNS.index("upright_gravity")
    assert np.sin(np.radians(5)) * 28 < 1.1 * LEARNING.scatter[upright]


def test_gravity_and_its_error_are_those_of_both_parts_together():
    """By a million draws of the two, whose covariance is known."""
    rng = np.random.default_rng(0)
    kept = Kept.nothing(1)
    kept.leg.mean[LEVEL:] = np.array([25, 3, 6, 0, 0.8, 0.1], F)[:, None]
    kept.leg.variance[LEVEL:] = np.array([0.3, 0.2, 1, 0.1, 0.01, 0.01], F)[:, None]
    upper = kept.leg.upper
    upper[LEVEL, UPRIGHT], upper[LEVEL, STIFFNESS], upper[UPRIGHT, STIFFNESS] = 0.5, -0.8, 0.2
    u = np.eye(3) + np.array([[0, 0.5, -0.8], [0, 0, 0.2], [0, 0, 0]])
    covariance = u @ np.diag([0.3, 0.2, 1.0]) @ u.T
    draws = rng.multivariate_normal([25, 3, 6], covariance, 1_000_000)
    gravity = np.hypot(draws[:, 0], draws[:, 1])
    found = learned(kept)
    assert found.ratio[0, 0] == pytest.approx(np.hypot(25, 3), rel=1e-6)
    wider = np.sqrt(LEARNING.caution)
    assert found.error[0, 0] == pytest.approx(wider * gravity.std(), rel=5e-3)  # 0.07 % of draws
    assert found.error[1, 0] == pytest.approx(wider * draws[:, 2].std(), rel=5e-3)


def test_the_simulated_legs_keep_their_energy():
    """Without damping, within the error of the method: 1e-9 of what a drop turns over."""
    none = np.zeros(2)
    legs = Legs(none + 27, none + 6, none, none, none, none, none)
    angle, rate, _ = legs.drop(none - 0.2, 5.0)
    energy = rate**2 / 2 + legs.gravity * np.sin(angle) + legs.stiffness * angle**2 / 2
    assert np.ptp(energy) < 1e-6
