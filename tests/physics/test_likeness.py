"""How like a leg is to those of its body, by the simple pendulum that swings as it does."""

from dataclasses import replace

import numpy as np
import pytest

from exoid.physics.anatomy.expect import expected_leg
from exoid.physics.anatomy.expected import STRANGE
from exoid.physics.anatomy.likeness import away, off_rate, pendulum_length, rate_of
from exoid.physics.leg import GRAVITY

LEG = expected_leg(74.0, 1.78)
USUAL = pendulum_length(LEG)


def gravity_of(deviations: float) -> float:
    """m l g / J of a leg whose J / (m l) is so many standard deviations longer than is expected."""
    assert USUAL.standard_deviation is not None
    return GRAVITY / USUAL.value * np.exp(-deviations * USUAL.standard_deviation / USUAL.value)


@pytest.mark.parametrize("deviations", [-4.0, 0.0, 2.0])
def test_how_far_a_leg_is_from_those_of_its_body_is_in_their_scatter(deviations):
    gravity = gravity_of(deviations)
    assert away(LEG, gravity) == pytest.approx(deviations, abs=1e-12)
    scatter = np.log(gravity_of(0.0) / gravity_of(1.0))
    vague = away(LEG, gravity, scatter * gravity)  # an error as large as the scatter
    assert vague == pytest.approx(deviations / np.sqrt(2), abs=1e-12)


@pytest.mark.parametrize("factor", [0.8, 1.25])
def test_times_that_are_told_a_factor_too_long_want_a_rate_higher_by_it(factor):
    slow = gravity_of(0.0) / factor**2
    assert rate_of(LEG, slow).value == pytest.approx(factor)
    assert off_rate(LEG, slow) == pytest.approx(factor - 1)
    assert off_rate(LEG, slow, slow) == 0.0  # by that error it may be any


def test_a_rate_is_doubted_from_one_leg_in_a_thousand_on():
    assert off_rate(LEG, gravity_of(STRANGE - 0.01)) == 0.0
    assert off_rate(LEG, gravity_of(STRANGE + 0.01)) > 0.0
    assert off_rate(LEG, gravity_of(-STRANGE - 0.01)) < 0.0


def test_of_a_leg_whose_scatter_is_unknown_nothing_is_doubted():
    assert off_rate(replace(LEG, covariance=None), gravity_of(9.0)) == 0.0
