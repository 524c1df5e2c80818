"""The bare leg from several weights: what they tell together, and what a wrong place does not."""

import numpy as np
import pytest

from exoid.physics.anatomy import expected_leg
from exoid.physics.leg import GRAVITY
from exoid.recordings.declared.subject import Subject
from exoid.watching.estimate.load import Mass
from exoid.watching.estimate.unload import Told, unloaded, unloading, with_mass

INERTIA, GRAVITY_RATIO, STIFFNESS, DAMPING = 0.42, 4.5 * 0.26 * GRAVITY / 0.42, 6.19, 0.786
ERRORS = 0.013, 0.012, 6e-5  # of a drop of twelve seconds
POINT = Subject(added_mass_gyration=0.0)


def ratios(weight: float = 0.0, distance: float = 0.4) -> tuple[float, float, float]:
    """Those of the leg with a point mass, by the parallel-axis theorem."""
    loaded = INERTIA + weight * distance**2
    gravity = INERTIA * GRAVITY_RATIO + weight * distance * GRAVITY
    return gravity / loaded, INERTIA * STIFFNESS / loaded, INERTIA * DAMPING / loaded


def found(told, subject=POINT):
    before = unloading(expected_leg(74.0, 1.78), subject, list(told) or [Mass()])
    return unloaded(before, told)


def test_two_weights_tell_the_inertia_to_a_percent():
    bare = found({Mass(): Told(ratios(), ERRORS), Mass(1.0, 0.4): Told(ratios(1.0), ERRORS)})
    inertia = bare.absolute[0]
    assert inertia.value == pytest.approx(INERTIA, rel=2e-3)  # what the prior pulls
    assert inertia.error < 0.01 * INERTIA
    for each, truth in zip(bare.ratios, ratios(), strict=True):
        assert abs(each.value - truth) < 0.2 * each.error


@pytest.mark.parametrize("said", [0.39, 0.405, 0.41])
def test_a_mass_off_its_place_makes_nothing_wrong_by_more_than_its_error(said):
    told = {Mass(): Told(ratios(), ERRORS), Mass(1.0, said): Told(ratios(1.0), ERRORS)}
    bare = found(told)
    assert abs(bare.absolute[0].value - INERTIA) < bare.absolute[0].error
    for each, truth in zip(bare.ratios, ratios(), strict=True):
        assert abs(each.value - truth) < each.error


def test_a_mass_whose_place_nobody_knows_is_placed_by_the_motion():
    told = {Mass(): Told(ratios(), ERRORS), Mass(1.0, placed=False): Told(ratios(1.0), ERRORS)}
    inertia = found(told).absolute[0]
    assert abs(inertia.value - INERTIA) < inertia.error < 0.02 * INERTIA


def test_a_shape_that_nobody_told_widens_the_error():
    told = {Mass(): Told(ratios(), ERRORS), Mass(1.0, 0.4): Told(ratios(1.0), ERRORS)}
    shaped, unknown = (found(told, subject).absolute[0].error for subject in (POINT, Subject()))
    assert unknown > 1.5 * shaped


def test_one_weight_leaves_the_inertia_to_the_prior():
    bare = found({Mass(1.0, 0.4): Told(ratios(1.0), ERRORS)})
    assert bare.narrowed > 0.8
    # And what the bare leg is, as far as its inertia is known.
    assert bare.ratios[1].error > 10 * ERRORS[1]
    assert abs(bare.ratios[1].value - STIFFNESS) < bare.ratios[1].error


def test_nothing_told_leaves_the_prior():
    bare = found({})
    assert bare.narrowed == pytest.approx(1.0)
    assert bare.absolute[0].error > 0.05 * bare.absolute[0].value


def test_a_known_torque_tells_the_inertia_of_one_weight():
    told = {Mass(): Told(ratios(), ERRORS, (INERTIA, 0.004))}
    assert found(told).absolute[0].error == pytest.approx(0.004, rel=0.05)


@pytest.mark.parametrize("mass", [Mass(), Mass(1.5, 0.37)])
def test_its_slopes_are_those_of_small_steps(mass):
    row = np.array([np.log(0.42), 27.0, 6.2, 0.79, 0.01, -0.02, 3e-3])
    slopes = with_mass(row, mass)[1]
    for at, step in enumerate(1e-6 * np.eye(row.size)):
        change = (with_mass(row + step, mass)[0] - with_mass(row - step, mass)[0]) / 2e-6
        np.testing.assert_allclose(slopes[:, at], change, atol=1e-6)  # of central differences
