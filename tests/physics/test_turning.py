"""How a leg with dry friction turns round: what a step makes of a change of how it began."""

import jax
import jax.numpy as jnp
import pytest

from exoid.physics.moment import Cycle, SegmentConstants
from exoid.physics.motion.extended_step import extended_step
from exoid.physics.motion.step import Drive
from exoid.physics.motion.with_terms import Motion
from exoid.physics.ratios import Ratios
from exoid.physics.state import LegState
from exoid.physics.terms.device.coulomb_friction import CoulombFriction

INERTIA, LEVEL = 0.42, 0.2  # kg m^2, N m
STEP = 0.01  # s
RATIOS = Ratios(*map(jnp.asarray, (27.0, 6.0, 0.8, 0.0)))
PULL = -27.0 * 0.955  # rad/s^2, at the angle below and about there
NEVER = Cycle(*map(jnp.asarray, (0.0, 1.0, 0.0, 0.0)))
PLACE = SegmentConstants(RATIOS, jnp.asarray(INERTIA), NEVER, jnp.zeros(()))


def rate_after(rate, push=0.0):
    """rad/s a step later, of a leg at -0.3 rad that a torque per inertia pushes."""
    start = Motion(LegState(jnp.asarray(-0.3), rate), (jnp.zeros(0),))
    terms = (CoulombFriction(jnp.asarray(LEVEL)),)
    drive = Drive(*[jnp.asarray(push)] * 3)
    end = extended_step(PLACE, terms, start, jnp.zeros(()), jnp.asarray(STEP), drive)
    return end.leg.angular_velocity


@pytest.mark.parametrize("share", [-0.5, 0.0, 0.5, 1.0])
def test_a_leg_that_turns_round_as_a_part_of_a_step_begins_forgets_nothing(share):
    """Friction would take `share` of the velocity that it can take in half a part of the step."""
    taken = LEVEL / INERTIA * STEP / CoulombFriction.substeps / 2
    slope = jax.jit(jax.grad(rate_after))(jnp.asarray(share * taken))
    # Turning round in a pull a takes (a - F/J) / (a + F/J) of a velocity with it: 0.96 here.
    assert float(slope) == pytest.approx(1.0, abs=0.06)


def test_a_leg_that_friction_holds_has_forgotten_how_it_moved():
    held = -PULL - 6.0 * 0.3  # that gravity and spring are all but balanced
    slope = jax.jit(jax.grad(rate_after))(jnp.asarray(1e-4), held)
    assert float(rate_after(jnp.asarray(1e-4), held)) == 0.0
    assert float(slope) == 0.0
