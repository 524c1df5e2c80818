"""Motion from physics: a leg, what drives it, and what Eq. 9 leaves out."""

from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
from jaxtyping import Array, Float

from exoid.physics.leg import LegModel
from exoid.physics.moment import Cycle, SegmentConstants
from exoid.physics.motion.extended_step import extended_step
from exoid.physics.motion.step import Drive, march
from exoid.physics.motion.with_terms import at_rest, delayed, observed
from exoid.physics.state import LegState
from exoid.physics.torque import CycleTorque, Torque

FIRST = np.zeros(())  # segment of a session


class Trajectory(eqx.Module):
    """A motion sampled at `time`: the leg's, and what encoder and gyro show of it.

    >>> leg = exoid.LegParameters(*map(jnp.asarray, (4.5, 0.42, 0.26, 0.33, 2.6)))
    >>> start = exoid.LegState(jnp.radians(-20.0), jnp.asarray(0.0))
    >>> time = jnp.arange(300) * 0.01  # s
    >>> motion = exoid.simulate(exoid.LegModel(leg, exoid.NoTorque()), start, time)
    >>> motion.angle.shape, bool((motion.angle == motion.shown_angle).all())
    ((300,), True)
    """

    time: Float[Array, " time"]  # s
    angle: Float[Array, " time"]  # rad
    angular_velocity: Float[Array, " time"]  # rad/s
    angular_acceleration: Float[Array, " time"]  # rad/s^2
    shown_angle: Float[Array, " time"]  # rad
    shown_velocity: Float[Array, " time"]  # rad/s


def simulate(
    model: LegModel,
    start: LegState,
    time: Float[Array, " time"],
    number: Float[Any, ""] = FIRST,
    *,
    parts: int | None = None,
) -> Trajectory:
    """Integrate Eq. 9 and the model's terms from `start` at `time[0]`, a step per sample interval.

    The steps may differ in length; the torque is taken at the begin, middle and end of each.
    The error falls with the fourth power of the step: at 100 Hz it is below 1e-6 rad for a leg. A
    step is cut into so many `parts`, or as many as the fastest term asks for.
    Terms begin as they are after a long rest at `start`; some change with the segment's `number`,
    which counts from 0.

    >>> leg = exoid.LegParameters(*map(jnp.asarray, (4.5, 0.42, 0.26, 0.33, 2.6)))
    >>> start = exoid.LegState(jnp.radians(-20.0), jnp.asarray(0.0))
    >>> time = jnp.arange(1500) * 0.01  # s
    >>> motion = jax.jit(exoid.simulate)(exoid.LegModel(leg, exoid.NoTorque()), start, time)
    >>> round(float(jnp.degrees(motion.angle[-1])))  # deg, where it hangs
    -73
    """
    torque = sample_torque(model.torque, time)
    drive = jax.tree.map(lambda samples: samples / model.leg.inertia, torque)
    pushed = jnp.concatenate([drive.begin, drive.end[-1:]])
    inertia, step = jnp.asarray(model.leg.inertia), jnp.diff(time)
    place = SegmentConstants(model.ratios(), inertia, cycle_of(model.torque), jnp.asarray(number))

    def advance(index, motion):
        push = jax.tree.map(lambda at: at[index], drive)
        now, long = time[index], step[index]
        return extended_step(place, model.terms, motion, now, long, push, parts=parts)

    def store(index, motion, stored):
        seen = observed(place, model.terms, motion, time[index], pushed[index])
        return jax.tree.map(lambda all, one: all.at[index].set(one), stored, seen)

    begin = at_rest(place, model.terms, start, time[0], pushed[0])
    one = observed(place, model.terms, begin, time[0], pushed[0])
    empty = jax.tree.map(lambda value: jnp.zeros(time.shape) * value, one)
    seen = march(advance, store, begin, empty, step.size)
    return Trajectory(
        time=time,
        angle=seen.angle,
        angular_velocity=seen.angular_velocity,
        angular_acceleration=seen.angular_acceleration,
        shown_angle=seen.shown_angle,
        shown_velocity=delayed(time, seen.shown_velocity, seen.shown_acceleration, seen.delay),
    )


def sample_torque(torque: Torque, time: Float[Array, " time"]) -> Drive:
    """The torque [N m] at the stage times of the steps between `time`."""
    at_samples = torque(time)
    middle = (time[:-1] + time[1:]) / 2
    return Drive(at_samples[:-1], torque(middle), at_samples[1:])


def cycle_of(torque: Torque) -> Cycle:
    """The voluntary cycle among what drives the leg; of amplitude 0 where there is none."""
    if isinstance(torque, CycleTorque):
        return Cycle(torque.amplitude, torque.period, torque.frequency, torque.onset)
    return Cycle(jnp.zeros(()), jnp.ones(()), jnp.zeros(()), jnp.zeros(()))
