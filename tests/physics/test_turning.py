"""How a leg with dry friction turns round: where it is then, and what a step makes of a change of
how it began.
"""

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from scipy.integrate import solve_ivp

import exoid
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


def swing(step):
    """deg, of a leg let go at -0.4 rad that friction brings to rest within 6 s."""
    leg = exoid.LegParameters(*map(jnp.asarray, (3.5, INERTIA, 0.32, 0.34, 2.5)))
    model = exoid.LegModel(leg, exoid.NoTorque(), terms=(CoulombFriction(jnp.asarray(LEVEL)),))
    time = jnp.arange(0.0, 6.0, step)
    begin = LegState(jnp.asarray(-0.4), jnp.zeros(()))
    return np.asarray(time), np.degrees(exoid.simulate(model, begin, time).angle)


def true_swing(times):
    """The same, by SciPy from turn to turn."""
    mass, inertia, distance, damping, stiffness = 3.5, INERTIA, 0.32, 0.34, 2.5

    def pulled(angle):
        return -mass * distance * 9.81 * np.cos(angle) - stiffness * angle

    at, begin, angles = 0.0, np.array([-0.4, 0.0]), np.empty(times.size)
    while abs(pull := pulled(begin[0])) > LEVEL:
        sense = np.sign(pull)

        def rates(_, now, sense=sense):
            return [now[1], (pulled(now[0]) - damping * now[1] - sense * LEVEL) / inertia]

        def still(_, now):
            return now[1]

        still.terminal, still.direction = True, -sense
        tight = {"method": "DOP853", "rtol": 1e-12, "atol": 1e-13, "first_step": 1e-4}
        half = solve_ivp(rates, (at, 20.0), begin, events=still, dense_output=True, **tight)
        within = (times >= at) & (times <= half.t[-1])
        angles[within] = half.sol(times[within])[0]
        at, begin = half.t[-1], np.array([half.y[0, -1], 0.0])
    angles[times > at] = begin[0]
    return np.degrees(angles)


def test_dry_friction_turns_over_within_a_step():
    """Of second order over a whole swing, and at 100 Hz below what an encoder's mean tells."""
    off = {}
    for step in (0.02, 0.01, 0.005):
        times, angle = swing(step)
        off[step] = np.sqrt(np.mean((angle - true_swing(times)) ** 2))
    assert off[0.01] < 2e-4
    for step in (0.02, 0.01):
        assert off[step] > 3 * off[step / 2]
