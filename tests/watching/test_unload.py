"""The bare leg from several weights: what they tell together, and what a wrong place does not."""

from dataclasses import replace

import numpy as np
import pytest

from exoid.physics.anatomy import expected_leg
from exoid.physics.anatomy.added_mass import UNUSUAL
from exoid.physics.leg import GRAVITY
from exoid.recordings.declared.subject import Subject
from exoid.watching.estimate.expect import of_mass, unloading
from exoid.watching.estimate.load import Mass
from exoid.watching.estimate.unload import Told, heavier, misplaced_by, unloaded, with_mass

INERTIA, GRAVITY_RATIO, STIFFNESS, DAMPING = 0.42, 4.5 * 0.26 * GRAVITY / 0.42, 6.19, 0.786
ERRORS = 0.013, 0.012, 6e-5  # of a drop of twelve seconds
# A point mass beside which the leg is as it is without.
POINT = Subject(
    added_mass_gyration=0.0,
    damping_under_load_uncertainty=0.0,
    stiffness_under_load_uncertainty=0.0,
)


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
    subjects = POINT, replace(POINT, added_mass_gyration=None)
    shaped, unknown = (found(told, subject).absolute[0].error for subject in subjects)
    assert unknown > 1.5 * shaped


@pytest.mark.parametrize("share", [-0.08, 0.04, 0.08])
@pytest.mark.parametrize("weight", [1.0, 2.0])
def test_a_leg_that_is_damped_otherwise_beside_a_mass_stays_within_the_errors(share, weight):
    """By a cuff or a hinge: d / J alone would make J wrong by up to 30 %, seven of its errors."""
    gravity, stiffness, damping = ratios(weight)
    loaded = Told((gravity, stiffness, (1 + share) * damping), ERRORS)
    bare = found({Mass(): Told(ratios(), ERRORS), Mass(weight, 0.4): loaded}, Subject())
    inertia = bare.absolute[0]
    assert abs(inertia.value - INERTIA) < 1.5 * inertia.error
    for each, truth in zip(bare.ratios, ratios(), strict=True):
        assert abs(each.value - truth) < each.error
    assert bare.misplaced < UNUSUAL


def test_of_several_weights_each_bears_what_it_is_heavier():
    masses = Mass(0.5), Mass(1.0), Mass(2.5)
    assert [heavier(each, masses) for each in masses] == [0.0, 0.25, 1.0]
    assert heavier(masses[0], masses[:1]) == 0.0  # nothing rubs more than itself


@pytest.mark.parametrize("said", [0.37, 0.43])
def test_a_mass_that_hangs_centimetres_off_is_told_and_its_errors_hold_it(said):
    """A tape that was read wrong is as likely to a fit (`fitting/multistart/seldom.py`)."""
    told = {Mass(): Told(ratios(), ERRORS), Mass(1.0, said): Told(ratios(1.0), ERRORS)}
    before = unloading(expected_leg(74.0, 1.78), POINT, list(told))
    bare = unloaded(before, told)
    assert abs(bare.absolute[0].value - INERTIA) < 2 * bare.absolute[0].error
    where = misplaced_by(before, bare)
    assert where is not None
    assert where.declared == said
    assert abs(where.acts - 0.4) < abs(where.acts - said)
    right = {Mass(): Told(ratios(), ERRORS), Mass(1.0, 0.405): Told(ratios(1.0), ERRORS)}
    before = unloading(expected_leg(74.0, 1.78), POINT, right)
    assert misplaced_by(before, unloaded(before, right)) is None


def test_each_mass_is_off_by_itself():
    """A tape is read anew for every place: what one mass showed of it says nothing of another."""
    rng, subject = np.random.default_rng(0), replace(POINT, damping_under_load_uncertainty=None)
    places = Mass(1.5, 0.4), Mass(1.0, 0.3)
    pulls = []
    for off in 5e-3 * rng.normal(size=(100, 2)):
        hung = zip(places, off, strict=True)
        told = {each: Told(ratios(each.weight, each.distance + o), ERRORS) for each, o in hung}
        inertia = found({Mass(): Told(ratios(), ERRORS), **told}, subject).absolute[0]
        pulls.append((inertia.value - INERTIA) / inertia.error)
    assert np.std(pulls) < 1.2  # of a hundred, where 1 is meant


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
    row = np.array([np.log(0.42), 27.0, 6.2, 0.79, *np.zeros(5), 0.01, -0.02, 3e-3, 0.02, -0.1])
    own = of_mass(1) if mass.weight else None
    slopes = with_mass(row, mass, own, 0.7)[1]
    for at, step in enumerate(1e-6 * np.eye(row.size)):
        above, below = (with_mass(row + off, mass, own, 0.7)[0] for off in (step, -step))
        change = (above - below) / 2e-6
        np.testing.assert_allclose(slopes[:, at], change, atol=1e-6)  # of central differences
