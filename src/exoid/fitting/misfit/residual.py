"""The one definition of misfit (Eq. 11): simulated against measured, in units of their noise."""

from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
from jaxtyping import Array, Float, Int

from exoid.fitting.data.conditioning_chain import Chain
from exoid.fitting.data.observation import Observation
from exoid.fitting.misfit.stage import Stage
from exoid.fitting.model.coordinates import Mounting, Own, Shared
from exoid.physics.leg import GRAVITY, Ratios
from exoid.physics.motion.step import Drive, march, rk4_step
from exoid.physics.state import LegState

NOTHING = Drive(*[np.zeros(())] * 3)  # is missing


class Equation(eqx.Module):
    """Eq. 9 of one segment, leg and added mass together, per inertia; what sensitivities act on."""

    ratios: Ratios
    cycle: Float[Any, ""]  # 1/s^2 for unit shape of Eq. 10
    torque: Float[Any, ""]  # 1/(kg m^2), for a measured torque
    share: Float[Any, ""]  # of the leg in the inertia that moves


def equation(
    shared: Shared, mounting: Mounting, own: Own, observation: Observation, stage: Stage
) -> Equation:
    """J + m_a (r^2 + k^2) and m l g + m_a r g move; the tether adds its stiffness and damping.

    A recorded second is (1 + clock) s long, so every rate of the equation counts as often.
    `mounting` is that of the segment, as `seated` gives it.
    """
    inertia, clock = jnp.exp(shared.log_inertia), 1 + of(mounting.clock)
    added = observation.added_mass * jnp.exp(of(mounting.log_added))
    moved = jnp.exp(observation.added_mass_moves * of(mounting.log_distance))
    distance = observation.added_mass_distance * moved
    extent = observation.added_mass_extent + of(mounting.extent)
    total = inertia + added * (distance**2 + extent)
    moment = shared.gravity * inertia + added * distance * GRAVITY
    return Equation(
        ratios=Ratios(
            gravity=clock**2 * moment / total,
            stiffness=clock**2 * shared.stiffness * inertia / total + stage.tether**2,
            damping=clock * shared.damping * inertia / total + 2 * stage.tether,
            thigh_angle=observation.thigh_angle + of(mounting.tilt),
        ),
        cycle=clock**2 * own.torque * inertia / total,
        torque=clock**2 / total,
        share=clock**2 * inertia / total,
    )


def sensor_map(mounting: Mounting) -> Float[Array, "3"]:
    """Encoder zero [rad], gyro scale [relative, of the angle's rate by the recording's own clock]
    and bias [rad/s] of the segment's recording.
    """
    scale = (1 + of(mounting.gyro_scale)) / (1 + of(mounting.clock)) - 1
    return jnp.stack([of(mounting.zero), scale, of(mounting.gyro_bias)])


def of(leaf: Float[Any, "*entry"]) -> Float[Any, ""]:
    """The segment's entry of the mounting, 0 where it is no unknown."""
    return leaf[0] if leaf.size else jnp.zeros(())


def advance(
    eq: Equation,
    state: LegState,
    index: Int[Array, ""],
    observation: Observation,
    stage: Stage,
    missing: Drive = NOTHING,
) -> LegState:
    """The step from sample `index` to the next, where a torque `missing` [J rad/s^2] acts too."""

    def push(cycle, torque, missing, guide_angle, guide_velocity):
        pull = stage.tether**2 * guide_angle + 2 * stage.tether * guide_velocity
        return eq.cycle * cycle + eq.torque * torque + eq.share * missing + pull

    def guide(at):
        return observation.guide_angle[at], observation.guide_velocity[at]

    now, after = guide(index), guide(index + 1)
    middle = jax.tree.map(lambda a, b: (a + b) / 2, now, after)
    cycle, torque = jax.tree.map(lambda at: at[index], (observation.cycle, observation.torque))
    drive = Drive(
        begin=push(cycle.begin, torque.begin, missing.begin, *now),
        middle=push(cycle.middle, torque.middle, missing.middle, *middle),
        end=push(cycle.end, torque.end, missing.end, *after),
    )
    step = observation.time[index + 1] - observation.time[index]
    return rk4_step(eq.ratios, state, step, drive)


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


def predict(
    shared: Shared,
    mounting: Mounting,
    own: Own,
    observation: Observation,
    stage: Stage,
    chain: Chain,
) -> LegState:
    """The whole segment as the leg would have moved, and sensors and chain would have shown it."""
    eq = equation(shared, mounting, own, observation, stage)
    zero, scale, bias = sensor_map(mounting)
    start = LegState(own.angle, own.angular_velocity)

    def store(index, state, folded):
        memory, shown = folded
        memory, now = chain.push(memory, state)
        return memory, jax.tree.map(lambda all, one: all.at[index].set(one), shown, now)

    def forward(index, state):
        return advance(eq, state, index, observation, stage)

    empty = LegState(jnp.zeros_like(observation.time), jnp.zeros_like(observation.time))
    shown = march(forward, store, start, (chain.begin(start), empty), stage.steps)[1]
    return LegState(shown.angle + zero, (1 + scale) * shown.angular_velocity + bias)
