"""An independent optimiser over the raw parameters comes to the same cost and parameters."""

import numpy as np
import pytest

from exoid.fitting.estimate import fit
from fit_cases import CYCLE, DROP, LOADED, recorded

# Half a chi square, where one standard error costs 1/2. SLSQP's finite differences stop it within
# 1e-7 of its minimum and the multipliers stop within 1e-3 of the noise; both are below this.
SAME_COST = 1e-6
SMALL_PART = 0.05  # of a standard error
HELD = 1e-4  # relative, of a value that a bound holds and that has no error worth the name
STARTS = np.array([[4.0, 0.35, 0.24, 0.5, 2.0, -3.0]])  # m, J, l, d, c, tau: a leg, somewhat off


def both(recording, starts=STARTS, **options):
    return (
        fit(recording, multistart=8, **options),
        fit(recording, method="slsqp", starts=starts, **options),
    )


def agree(one, other):
    assert other.multistart.succeeded > 0
    assert one.loss == pytest.approx(other.loss, rel=SAME_COST)
    assert one.noise_scale == pytest.approx(other.noise_scale, rel=1e-5)
    for name, expected in (one.parameters | one.ratios).items():
        found = (other.parameters | other.ratios)[name]
        if expected.value is None:
            assert found.value is None, name
            continue
        error = max(SMALL_PART * (expected.standard_error or 0), HELD * abs(expected.value))
        assert found.value == pytest.approx(expected.value, abs=error), name
        if name in one.parameters:
            assert found.determined_by == expected.determined_by, name
        if expected.standard_error:
            assert found.standard_error == pytest.approx(expected.standard_error, rel=0.01), name


@pytest.mark.proof
def test_both_methods_agree_on_a_cycle():
    agree(*both(recorded(CYCLE)))


@pytest.mark.proof
def test_both_methods_agree_from_several_starts():
    others = np.vstack([STARTS, [5.0, 0.55, 0.28, 0.2, 3.5, -6.0]])
    one, other = both(recorded(CYCLE), others)
    agree(one, other)
    assert other.multistart.at_best == len(others)


@pytest.mark.proof
def test_both_methods_agree_where_the_leg_is_none_of_the_tables():
    """m l^2 > J there: no body has such a leg, and both leave its tables, and tell its ratios."""
    one, other = both(recorded(CYCLE, inertia=0.30, com_distance=0.28))
    agree(one, other)
    assert one.parameters["inertia"].value is None
    assert one.ratios["gravity_over_inertia"].value is not None


def test_the_inertia_is_as_small_as_a_rigid_leg_allows_where_a_sure_distance_asks_for_less():
    """m l^2 <= J (Eq. 12) then holds as an equality."""
    sure = {"com_distance": (0.28, 0.002)}  # m; by its motion, J / (m l) is 0.24 m
    found = fit(recorded(CYCLE, inertia=0.30, com_distance=0.28), multistart=8, expect=sure)
    chosen = {name: each.value for name, each in found.parameters.items()}
    least = chosen["mass"] * chosen["com_distance"] ** 2
    assert chosen["inertia"] == pytest.approx(least, rel=1e-5)  # multipliers stop within 1e-6
    assert any("m l^2 <= J" in note for note in found.notes)


@pytest.mark.proof
def test_both_methods_agree_where_a_parameter_is_at_its_bound():
    one, other = both(recorded(CYCLE, stiffness=4.6), prior="paper", bounds="paper")
    agree(one, other)
    for result in (one, other):
        assert result.parameters["stiffness"].value == pytest.approx(4.0, abs=1e-5)
        assert result.parameters["stiffness"].determined_by == "bound"


@pytest.mark.proof
def test_both_methods_agree_where_two_limits_hold_at_once():
    one, other = both(
        recorded(CYCLE, inertia=0.30, com_distance=0.28), prior="paper", bounds="paper"
    )
    agree(one, other)
    assert one.parameters["mass"].value == pytest.approx(6.0, abs=1e-5)


@pytest.mark.proof
def test_both_methods_agree_on_two_segments_with_a_known_mass():
    agree(*both(recorded(DROP, LOADED)))
