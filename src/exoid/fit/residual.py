"""The one definition of misfit (Eq. 11): simulated against measured, in units of their noise."""

import jax
import jax.numpy as jnp
from jaxtyping import Array, Float

from exoid.fit.chain import Chain
from exoid.fit.coordinates import Own, Shared
from exoid.fit.observation import Observation
from exoid.physics.leg import GRAVITY, Ratios
from exoid.physics.simulate import Drive, Trajectory, integrate
from exoid.physics.state import LegState


def misfit(
    shared: Shared, own: Own, observation: Observation, tether: Float[Array, ""], chain: Chain
) -> Float[Array, " residual"]:
    """Angle and angular velocity of one segment minus the measured ones, over their noise."""
    simulated = predict(shared, own, observation, tether, chain)
    return jnp.concatenate(
        [
            observation.angle_weight * (simulated.angle - observation.angle),
            observation.velocity_weight
            * (simulated.angular_velocity - observation.angular_velocity),
        ]
    )


def predict(
    shared: Shared, own: Own, observation: Observation, tether: Float[Array, ""], chain: Chain
) -> Trajectory:
    """The segment as the leg would have moved and the chain of conditioning would have shown it."""
    ratios, drive = loaded(shared, own, observation)
    ratios, drive = tied(ratios, drive, observation, tether)
    start = LegState(own.angle, own.angular_velocity)
    return chain(integrate(ratios, start, observation.time, drive))


def loaded(shared: Shared, own: Own, observation: Observation) -> tuple[Ratios, Drive]:
    """Eq. 9 per inertia of leg and added mass together, J + m_a r^2 and m l g + m_a r g."""
    inertia = jnp.exp(shared.log_inertia)
    moment = observation.added_mass * observation.added_mass_distance
    total = inertia + moment * observation.added_mass_distance
    ratios = Ratios(
        gravity=(shared.gravity * inertia + moment * GRAVITY) / total,
        stiffness=shared.stiffness * inertia / total,
        damping=shared.damping * inertia / total,
    )
    drive = jax.tree.map(
        lambda cycle, torque: (own.torque * inertia * cycle + torque) / total,
        observation.cycle,
        observation.torque,
    )
    return ratios, drive


def tied(
    ratios: Ratios, drive: Drive, observation: Observation, tether: Float[Array, ""]
) -> tuple[Ratios, Drive]:
    """Eq. 9 with a critically damped spring of `tether` [rad/s] to the measured motion.

    A start that is far from the leg begins tied, which makes the misfit nearly linear in the
    parameters, and ends free (tether 0).
    """
    spring, damper = tether**2, 2 * tether
    pull = spring * observation.guide_angle + damper * observation.guide_velocity
    tied_ratios = Ratios(ratios.gravity, ratios.stiffness + spring, ratios.damping + damper)
    return tied_ratios, Drive(
        begin=drive.begin + pull[:-1],
        middle=drive.middle + (pull[:-1] + pull[1:]) / 2,
        end=drive.end + pull[1:],
    )
