"""Where a leg is in balance, and how hard it is drawn there, against legs whose truth is known."""

import numpy as np
import pytest

from exoid.recordings.conventions.balance import balance
from exoid.recordings.measured.segment import Segment
from legs import ADULT, CHILD, SPASTIC, balance_of, drop

GYRO = {"gyro": False, "noise": (0.0, 0.0)}


@pytest.mark.parametrize("start", [-0.1, -0.6, -1.0])
@pytest.mark.parametrize("leg", [ADULT, CHILD], ids=["adult", "child"])
def test_the_balance_of_a_swinging_leg_is_where_gravity_and_spring_are_equal(leg, start):
    found = balance(drop(leg, start))
    # A spring is no sine: over a swing of a radian that moves the balance by a degree or two.
    assert found.angle == pytest.approx(balance_of(leg), abs=0.05)
    assert found.explained > 0.99
    gravity, stiffness, _ = leg
    pull = -gravity * np.sin(balance_of(leg)) + stiffness
    assert found.pull == pytest.approx(pull, rel=0.1)  # for the same reason


def test_of_a_leg_without_a_spring_the_regression_is_the_model():
    found = balance(drop((28.0, 0.0, 0.5), -0.3, **GYRO))
    # The trapezoid of 40 samples under psi is exact to a hundredth.
    assert found.angle == pytest.approx(-np.pi / 2, abs=2e-3)
    assert found.pull == pytest.approx(28.0, rel=1e-2)


def test_it_does_not_matter_how_the_angle_is_counted():
    plain = drop(ADULT)
    for sign, shift in ((-1.0, 0.0), (1.0, np.pi / 2), (-1.0, 2.0)):
        turned = Segment(plain.time, raw_angle=sign * plain.raw_angle + shift)
        found, before = balance(turned), balance(plain)
        expected = sign * before.angle + shift
        assert np.cos(found.angle - expected) == pytest.approx(1.0, abs=1e-9)
        assert found.pull == pytest.approx(before.pull, rel=1e-6)


def test_a_camera_tells_it_within_its_own_error():
    for seed in range(8):
        found = balance(drop(ADULT, -0.3, gyro=False, noise=(0.0175, 0.0), step=1 / 30, seed=seed))
        assert abs(found.angle - balance_of(ADULT)) < 4 * found.angle_error + 0.02
        assert found.angle_error < 0.1


def test_noise_makes_it_less_sure():
    quiet, loud = (balance(drop(SPASTIC, noise=(noise, 0.0))) for noise in (1e-4, 1e-2))
    assert loud.angle_error > 3 * quiet.angle_error
    assert loud.explained < quiet.explained


def test_what_is_too_short_or_still_has_none():
    assert balance(drop(duration=0.5)) is None
    assert balance(Segment(np.arange(100) * 0.01, raw_angle=np.full(100, -1.3))) is None
    assert balance(Segment(np.arange(3) * 0.01, raw_angle=np.array([-1.0, -1.1, -1.2]))) is None
