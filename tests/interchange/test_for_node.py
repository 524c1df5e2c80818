"""A fitted leg as a node holds it, and what it cannot hold refused by name."""

from dataclasses import replace

import jax.numpy as jnp
import pytest

from exoid.interchange.for_node import Wanted, for_node
from exoid.interchange.model.gather import gather
from exoid.physics.terms.device.coulomb_friction import CoulombFriction

HALF = Wanted(0.5, 0.0, 0.0, 0.25, 5.0, 20.0)


LEVEL = 0.2  # N m


@pytest.fixture(scope="module")
def weighed(fitted):
    """A fit that knows the inertia, by a known mass, with dry friction in place of its own term."""
    told = fitted.terms["quadratic_drag"]["coefficient"]
    friction = CoulombFriction(jnp.asarray(LEVEL))
    return replace(fitted, fitted_terms=(friction,), terms={"coulomb_friction": {"level": told}})


@pytest.fixture(scope="module")
def ratios(weighed):
    """The same where nothing told the inertia."""
    untold = replace(weighed.parameters["inertia"], value=None)
    return replace(weighed, parameters=weighed.parameters | {"inertia": untold})


def test_a_leg_with_dry_friction_is_held_to_the_last_digit(weighed):
    joint = gather(weighed, None)
    found = for_node(weighed, HALF)
    own = {name: joint.value[name] for name in ("gravity", "stiffness", "damping", "inertia")}
    assert {name: getattr(found.parameters, name) for name in own} == own
    assert found.parameters.friction == LEVEL
    assert found.parameters.thigh_angle == joint.thigh_angle
    assert (found.parameters.gravity_share, found.parameters.limit) == (0.5, 5.0)
    assert found.left == ()


def test_a_segment_has_its_added_mass(weighed):
    bare, loaded = (for_node(weighed, HALF, segment=each).parameters for each in (0, 1))
    assert loaded.gravity > bare.gravity
    assert loaded.inertia > bare.inertia


def test_of_ratios_alone_an_inertia_must_be_told_which_scales_all_of_them(weighed, ratios):
    with pytest.raises(ValueError, match="its ratios alone make no torque in N m"):
        for_node(ratios, HALF)
    found = for_node(ratios, HALF, inertia=0.3).parameters
    assert found.inertia == pytest.approx(0.3, rel=1e-12)
    own = for_node(weighed, HALF).parameters
    for name in ("gravity", "stiffness", "damping", "friction"):
        ratio = getattr(own, name) / own.inertia
        assert getattr(found, name) / 0.3 == pytest.approx(ratio, rel=1e-12)


def test_an_inertia_beside_one_that_is_known_is_refused(weighed):
    with pytest.raises(ValueError, match="the fit has told the leg's inertia"):
        for_node(weighed, HALF, inertia=0.3)


def test_a_term_without_a_counterpart_is_named(fitted):
    with pytest.raises(ValueError, match=r"nothing that acts like quadratic_drag \("):
        for_node(fitted, HALF)


def test_what_a_solver_leaves_below_nothing_is_nothing(weighed):
    rounded = replace(weighed, fitted_terms=(CoulombFriction(jnp.asarray(-2e-8)),))
    assert for_node(rounded, HALF).parameters.friction == 0.0


def test_a_fit_that_goes_astray_and_a_leg_beyond_a_nodes_range_are_refused(weighed):
    with pytest.raises(ValueError, match="does not follow its recording"):
        for_node(replace(weighed, astray="it misses"), HALF)
    with pytest.raises(ValueError, match=r"limit = 40 N m: a node takes 0 to 15.75"):
        for_node(weighed, replace(HALF, limit=40.0))
