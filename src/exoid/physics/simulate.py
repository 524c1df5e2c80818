"""Motion from physics, in the only time loop: classical Runge-Kutta of order four."""

from collections.abc import Callable
from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
from jaxtyping import Array, Float, Int, PyTree

from exoid.physics.leg import LegModel, Ratios, angular_acceleration
from exoid.physics.state import LegState
from exoid.physics.torque import Torque


class Trajectory(eqx.Module):
    """A motion sampled at `time`."""

    time: Float[Array, " time"]  # s
    angle: Float[Array, " time"]  # rad
    angular_velocity: Float[Array, " time"]  # rad/s
    angular_acceleration: Float[Array, " time"]  # rad/s^2


class Drive(eqx.Module):
    """The torque per inertia [rad/s^2] at the three stage times of every step."""

    begin: Float[Any, "*steps"]
    middle: Float[Any, "*steps"]
    end: Float[Any, "*steps"]


def simulate(model: LegModel, start: LegState, time: Float[Array, " time"]) -> Trajectory:
    """Integrate Eq. 9 from `start` at `time[0]`, one Runge-Kutta step per sample interval.

    The steps may differ in length; the torque is taken at the begin, middle and end of each.
    The error falls with the fourth power of the step: at 100 Hz it is below 1e-6 rad for a leg.
    """
    torque = sample_torque(model.torque, time)
    drive = jax.tree.map(lambda samples: samples / model.leg.inertia, torque)
    ratios, step = model.ratios(), jnp.diff(time)

    def advance(index, state):
        return rk4_step(ratios, state, step[index], jax.tree.map(lambda at: at[index], drive))

    def store(index, state, states):
        return jax.tree.map(lambda all, one: all.at[index].set(one), states, state)

    empty = jax.tree.map(lambda value: jnp.full(time.shape, value), start)
    states = march(advance, store, start, empty, step.size)
    pushed = jnp.concatenate([drive.begin, drive.end[-1:]])
    acceleration = angular_acceleration(ratios, states, pushed)
    return Trajectory(time, states.angle, states.angular_velocity, acceleration)


def sample_torque(torque: Torque, time: Float[Array, " time"]) -> Drive:
    """The torque [N m] at the stage times of the steps between `time`."""
    at_samples = torque(time)
    middle = (time[:-1] + time[1:]) / 2
    return Drive(at_samples[:-1], torque(middle), at_samples[1:])


def march(
    advance: Callable[[Int[Array, ""], PyTree], PyTree],
    fold: Callable[[Int[Array, ""], PyTree, PyTree], PyTree],
    state: PyTree,
    folded: PyTree,
    steps: int | Int[Array, ""],
) -> PyTree:
    """The only time loop: `advance(index, state)` step by step, every state folded into a result.

    `fold(index, state, folded)` sees the states 0 to `steps`. A number of steps that is known only
    at run time lets one compiled program serve any length, but not reverse-mode derivatives.
    """

    def step(index, carry):
        now, gathered = carry
        following = advance(index, now)
        return following, fold(index + 1, following, gathered)

    return jax.lax.fori_loop(0, steps, step, (state, fold(jnp.array(0), state, folded)))[1]


def rk4_step(
    ratios: Ratios, state: LegState, step: Float[Array, "*batch"], drive: Drive
) -> LegState:
    """One classical Runge-Kutta step of length `step` [s]."""

    def rate(at: LegState, push: Float[Array, "*batch"]) -> LegState:
        return LegState(at.angular_velocity, angular_acceleration(ratios, at, push))

    def moved(slope: LegState, by: Float[Array, "*batch"]) -> LegState:
        return jax.tree.map(lambda x, s: x + by * s, state, slope)

    first = rate(state, drive.begin)
    second = rate(moved(first, step / 2), drive.middle)
    third = rate(moved(second, step / 2), drive.middle)
    fourth = rate(moved(third, step), drive.end)
    mean = jax.tree.map(
        lambda a, b, c, d: (a + 2 * b + 2 * c + d) / 6, first, second, third, fourth
    )
    return moved(mean, step)
