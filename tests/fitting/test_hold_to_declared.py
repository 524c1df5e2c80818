"""What a model misses is not made up for by sensors, seat or clock."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from exoid.fitting.estimate import fit
from exoid.fitting.model.systematics import DECLARED_NOTHING
from exoid.fitting.multistart.hold_to_declared import less_told
from exoid.physics.leg import LegModel
from exoid.physics.terms.device.coulomb_friction import CoulombFriction
from exoid.physics.torque import NoTorque
from exoid.twin.motion import Movement
from exoid.twin.protocols import record
from fit_cases import BODY, DROP, leg, recorded

FREE = ("zero", "tilt", "clock")  # nothing else in a single drop tells them
DROPS = (Movement(-0.35, 4.0), Movement(-0.87, 4.0))  # rad, s


@pytest.fixture(scope="module")
def rubbing():
    """A fit to a leg in a worn hinge: 0.25 N m of dry friction."""
    worn = LegModel(leg(), NoTorque(), terms=(CoulombFriction(jnp.asarray(0.25)),))
    return fit(record(worn, DROPS, jax.random.key(0), subject=BODY), multistart=2)


@pytest.mark.proof
def test_dry_friction_is_not_explained_by_zero_seat_or_clock(rubbing):
    found = rubbing.basis.ended.best.coordinates.mounting
    for name in FREE:
        away = getattr(found, name)[0, 0] / getattr(DECLARED_NOTHING, name)
        assert abs(away) < 3, name  # standard deviations of what is declared
    assert rubbing.disturbance.cause == "torque"


@pytest.mark.proof
def test_the_gyro_is_not_blamed_for_what_the_model_misses():
    """In 0.4 N m of dry friction the fit takes 0.8 % of scale from a gyro that is exact, as the
    encoder shows.
    """
    worn = LegModel(leg(), NoTorque(), terms=(CoulombFriction(jnp.asarray(0.4)),))
    drops = (Movement(-0.17, 4.0), Movement(-0.52, 4.0))
    found = fit(record(worn, drops, jax.random.key(0), subject=BODY), multistart=2)
    taken = found.mountings[0].gyro_scale
    assert taken is not None
    assert abs(taken.value) > 0.002
    assert not any("disagree" in each for each in found.notes)


def test_the_leg_stays_one_that_the_body_has(rubbing):
    """Before, its inertia came out twice as large as it was."""
    truth = leg()
    for name in ("inertia", "mass"):
        each = rubbing.parameters[name]
        assert abs(each.value - float(getattr(truth, name))) < 2 * each.standard_error


def test_what_follows_within_the_noise_is_held_to_nothing():
    basis = fit(recorded(DROP), multistart=2).basis
    less = less_told(basis.problem, basis.ended.best, 0, basis.ended.disturbance)
    assert max(float(np.max(each, initial=1.0)) for each in less.values()) < 1.05
