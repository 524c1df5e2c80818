"""The only time loop: classical Runge-Kutta of order four over the sample times."""

import equinox as eqx
import jax
import jax.numpy as jnp
from jaxtyping import Array, Float

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

    begin: Float[Array, "*steps"]
    middle: Float[Array, "*steps"]
    end: Float[Array, "*steps"]


def simulate(model: LegModel, start: LegState, time: Float[Array, " time"]) -> Trajectory:
    """Integrate Eq. 9 from `start` at `time[0]`, one Runge-Kutta step per sample interval.

    The steps may differ in length; the torque is taken at the begin, middle and end of each.
    The error falls with the fourth power of the step: at 100 Hz it is below 1e-6 rad for a leg.
    """
    torque = sample_torque(model.torque, time)
    drive = jax.tree.map(lambda samples: samples / model.leg.inertia, torque)
    return integrate(model.ratios(), start, time, drive)


def sample_torque(torque: Torque, time: Float[Array, " time"]) -> Drive:
    """The torque [N m] at the stage times of the steps between `time`."""
    at_samples = torque(time)
    middle = (time[:-1] + time[1:]) / 2
    return Drive(at_samples[:-1], torque(middle), at_samples[1:])


def integrate(
    ratios: Ratios, start: LegState, time: Float[Array, " time"], drive: Drive
) -> Trajectory:
    """The loop of `simulate`, for callers that hold the coefficients per inertia already."""

    def advance(state, step_and_drive):
        after = rk4_step(ratios, state, *step_and_drive)
        return after, after

    _, later = jax.lax.scan(advance, start, (jnp.diff(time), drive))
    states = jax.tree.map(lambda first, rest: jnp.concatenate([first[None], rest]), start, later)
    pushed = jnp.concatenate([drive.begin, drive.end[-1:]])
    acceleration = angular_acceleration(ratios, states, pushed)
    return Trajectory(time, states.angle, states.angular_velocity, acceleration)


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
