"""A leg that bounces off a stop, beside SciPy, which finds the instants itself."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from scipy.integrate import solve_ivp

from exoid.physics.leg import LegModel, LegParameters
from exoid.physics.motion.simulate import simulate
from exoid.physics.state import LegState
from exoid.physics.terms.device.hard_stop import HardStop
from exoid.physics.torque import NoTorque

LEG = LegParameters(*map(jnp.asarray, (4.5, 0.42, 0.26, 0.33, 2.6)))
STOP, RATIO, LASTING = np.radians(-85.0), 0.5, 2.0


def shown(values, rate=100):
    """Angle and rate of a drop: where it begins [rad], contact time [s], stop [rad], damping."""
    begin, contact, stop, ratio = values
    term = HardStop(contact, jnp.asarray(1.2), stop, ratio)
    time = jnp.arange(round(LASTING * rate) + 1) / rate
    start = LegState(begin, jnp.zeros(()))
    motion = simulate(LegModel(LEG, NoTorque(), terms=(term,)), start, time)
    return jnp.stack([motion.angle, motion.angular_velocity])


def bounced(begin: float, contact: float) -> np.ndarray:
    """The same by SciPy, a piece for every time in touch and every time out of it."""
    ratios, stiff = LegModel(LEG, NoTorque()).ratios(), np.pi / contact
    gravity, spring, damping, _ = (float(each) for each in jax.tree.leaves(ratios))

    def pushed(state, touching):
        push = stiff**2 * (STOP - state[0]) - 2 * RATIO * stiff * state[1]
        return max(push, 0.0) if touching else 0.0

    time = np.arange(round(LASTING * 100) + 1) / 100
    found, now, state, touching = np.zeros((2, time.size)), 0.0, np.array([begin, 0.0]), False
    while now < LASTING:

        def rate(_, at, touching=touching):
            pull = -gravity * np.cos(at[0]) - spring * at[0] - damping * at[1]
            return np.array([at[1], pull + pushed(at, touching)])

        def passes(_, at):
            return at[0] - STOP

        passes.terminal, passes.direction = True, 1.0 if touching else -1.0
        piece = solve_ivp(
            rate, (now, LASTING), state, "DOP853", events=passes, rtol=1e-11, atol=1e-12,
            dense_output=True, max_step=1e-3 if touching else 0.02,
        )  # fmt: skip
        inside = (time >= now) & (time <= piece.t[-1])
        found[:, inside] = piece.sol(time[inside])
        now, state, touching = piece.t[-1], piece.y[:, -1], not touching
    return found


@pytest.mark.parametrize("contact", [0.03, 0.1])
def test_bounces_are_those_of_scipy(contact):
    """Wherever within a part of a step the leg touches; a gyro errs by 5 mrad/s, a count is 1.5
    mrad.
    """
    begins = np.radians(-20.0) + np.linspace(0.0, 2e-3, 5)
    moved = jax.jit(shown)
    for begin in begins:
        missed = np.asarray(moved(jnp.array([begin, contact, STOP, RATIO]))) - bounced(
            begin, contact
        )
        assert np.abs(missed[0]).max() < 5e-4
        assert np.sqrt(np.mean(missed[1] ** 2)) < 1e-3


def test_derivatives_are_those_of_differences():
    """Those of a leg that touches a little earlier, too."""
    at = jnp.array([-0.35, 0.03, STOP, RATIO])
    slopes = np.asarray(jax.jit(jax.jacfwd(shown))(at))[0]
    moved = jax.jit(shown)
    for number, step in enumerate(1e-6 * np.eye(4)):
        expected = np.asarray(moved(at + step) - moved(at - step))[0] / 2e-6
        assert np.abs(slopes[:, number] - expected).max() < 2e-3 * np.abs(expected).max()
