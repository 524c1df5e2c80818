"""The one definition of misfit (Eq. 11): simulated against measured, in units of their noise."""

from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
from jaxtyping import Array, Float, Int

from exoid.fitting.data.conditioning_chain import Chain
from exoid.fitting.data.observation import Observation
from exoid.fitting.data.stage import Stage
from exoid.fitting.misfit.equation import Equation, applied, equation, of, place_of
from exoid.fitting.model.coordinates import Unknowns
from exoid.fitting.model.mounting import Mounting
from exoid.physics.motion.after_release import after_release
from exoid.physics.motion.extended_step import extended_step
from exoid.physics.motion.step import Drive, march
from exoid.physics.motion.with_terms import Motion, delayed, observed
from exoid.physics.record import record
from exoid.physics.state import LegState
from exoid.physics.term import Term

NOTHING = Drive(*[np.zeros(())] * 3)  # is missing


def sensor_map(mounting: Mounting) -> Float[Array, "3"]:
    """Encoder zero [rad], gyro scale [relative, of the angle's rate by the recording's own clock]
    and bias [rad/s] of the segment's recording.
    """
    scale = (1 + of(mounting.gyro_scale)) / (1 + of(mounting.clock)) - 1
    return jnp.stack([of(mounting.zero), scale, of(mounting.gyro_bias)])


def begin(eq: Equation, start: LegState, observation: Observation, stage: Stage) -> Motion:
    """The motion at the first sample, of a leg that was let go at rest."""
    place = place_of(eq, observation, stage)
    pushed = push_at(eq, 0, observation, stage)
    return after_release(place, eq.terms, start, observation.time[0], pushed)


def advance(
    eq: Equation,
    motion: Motion,
    index: Int[Array, ""],
    observation: Observation,
    stage: Stage,
    missing: Drive = NOTHING,
) -> Motion:
    """The step from sample `index` to the next, where a torque `missing` [J rad/s^2] acts too."""

    def push(cycle, torque, missing, guide):
        return eq.cycle * cycle + applied(eq, torque) + eq.share * missing + pull(guide, stage)

    now, after = guide(index, observation), guide(index + 1, observation)
    middle = jax.tree.map(lambda a, b: (a + b) / 2, now, after)
    cycle, torque = jax.tree.map(lambda at: at[index], (observation.cycle, observation.torque))
    drive = Drive(
        begin=push(cycle.begin, torque.begin, missing.begin, now),
        middle=push(cycle.middle, torque.middle, missing.middle, middle),
        end=push(cycle.end, torque.end, missing.end, after),
    )
    time = observation.time[index]
    step = observation.time[index + 1] - time
    place = place_of(eq, observation, stage)
    finer, compact = observation.parts, stage.compact
    return extended_step(place, eq.terms, motion, time, step, drive, parts=finer, compact=compact)


def guide(at: Int[Array, ""], observation: Observation) -> tuple[Array, Array]:
    """The measured motion that a start is tied to."""
    return observation.guide_angle[at], observation.guide_velocity[at]


def pull(guide: tuple[Array, Array], stage: Stage) -> Array:
    """What the tether adds to the drive [rad/s^2]."""
    angle, velocity = guide
    return stage.tether**2 * angle + 2 * stage.tether * velocity


def push_at(eq: Equation, index, observation: Observation, stage: Stage) -> Array:
    """The drive per inertia [rad/s^2] at a sample."""
    before = jnp.maximum(jnp.asarray(index) - 1, 0)

    def at(drive: Drive):
        return jnp.where(index == 0, drive.begin[0], drive.end[before])

    drawn = pull(guide(jnp.asarray(index), observation), stage)
    return eq.cycle * at(observation.cycle) + applied(eq, at(observation.torque)) + drawn


@record
class Shown:
    """What the sensors show, but for the recording's own map of them."""

    motion: LegState
    angular_acceleration: Float[Any, "*time"]  # rad/s^2, for the gyro's delay
    delay: Float[Any, "*time"]  # s, of the gyro


def shows(terms: tuple[Term, ...]) -> bool:
    """Do the sensors show another motion than the leg's?"""
    return any(type(term).shown is not Term.shown for term in terms)


def glimpse(
    eq: Equation, motion: Motion, index: Int[Array, ""], observation: Observation, stage: Stage
) -> Shown:
    """What the sensors show of a sample, before the gyro's delay."""
    if not shows(eq.terms):
        none = jnp.zeros_like(motion.leg.angle)
        return Shown(motion.leg, none, none)
    place, pushed = place_of(eq, observation, stage), push_at(eq, index, observation, stage)
    seen = observed(place, eq.terms, motion, observation.time[index], pushed)
    leg = LegState(seen.shown_angle, seen.shown_velocity)
    return Shown(leg, seen.shown_acceleration, seen.delay)


def late(shown: Shown, observation: Observation, stage: Stage) -> LegState:
    """A whole segment as the sensors show it, the gyro by its delay behind."""
    rate, slope = shown.motion.angular_velocity, shown.angular_acceleration
    behind = delayed(observation.time, rate, slope, shown.delay, stage.steps)
    return LegState(shown.motion.angle, behind)


def residual(
    shown: LegState, sensors: Float[Any, "3"], index: Int[Array, ""], observation: Observation
) -> Float[Array, "2"]:
    """Angle and angular velocity minus the measured ones at sample `index`, over their noise.

    `sensors` is the recording's `sensor_map`.
    """
    zero, scale, bias = sensors
    angle = shown.angle + zero - observation.angle[index]
    velocity = (1 + scale) * shown.angular_velocity + bias - observation.angular_velocity[index]
    return jnp.stack(
        [observation.angle_weight[index] * angle, observation.velocity_weight[index] * velocity]
    )


def predict(unknowns: Unknowns, observation: Observation, stage: Stage, chain: Chain) -> LegState:
    """The whole segment as the leg would have moved, and sensors and chain would have shown it."""
    eq, own = equation(unknowns, observation, stage), unknowns.own
    start = LegState(own.angle, own.angular_velocity)
    return predicted(eq, start, sensor_map(unknowns.mounting), observation, stage, chain)


def predicted(
    eq: Equation,
    start: LegState,
    sensors: Float[Array, "3"],
    observation: Observation,
    stage: Stage,
    chain: Chain,
) -> LegState:
    """The same from the equation, the first state and the map of the sensors."""
    zero, scale, bias = sensors
    motion = begin(eq, start, observation, stage)

    def store(index, motion, folded):
        memory, table = folded
        memory, now = through(chain, memory, glimpse(eq, motion, index, observation, stage))
        return memory, jax.tree.map(lambda all, one: all.at[index].set(one), table, now)

    def forward(index, motion):
        return advance(eq, motion, index, observation, stage)

    first = glimpse(eq, motion, jnp.asarray(0), observation, stage)
    empty = jax.tree.map(lambda leaf: jnp.zeros(observation.time.shape), first)
    seen = march(forward, store, motion, (chain.begin(first.motion), empty), stage.steps)[1]
    shown = late(seen, observation, stage) if shows(eq.terms) else seen.motion
    return LegState(shown.angle + zero, (1 + scale) * shown.angular_velocity + bias)


def through(chain: Chain, memory: Any, shown: Shown) -> tuple[Any, Shown]:
    """A sample after the chain of conditioning, and the chain's memory."""
    memory, now = chain.push(memory, shown.motion)
    return memory, Shown(now, shown.angular_acceleration, shown.delay)
