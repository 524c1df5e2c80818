"""The leg as a damped pendulum with a spring: the equation of motion (Eq. 9) and its parameters."""

from dataclasses import field
from typing import Any

import equinox as eqx
import jax.numpy as jnp
from jaxtyping import Array, Float, Inexact

from exoid.physics.gravity import GRAVITY
from exoid.physics.parameter import parameter
from exoid.physics.ratios import Ratios, horizontal
from exoid.physics.record import record
from exoid.physics.state import LegState
from exoid.physics.torque import Torque
from exoid.physics.waves import cos


@record
class LegParameters:
    """Shank, foot and exoskeleton together. The ranges are the bounds of Eq. 13.

    >>> leg = exoid.LegParameters(*map(jnp.asarray, (4.5, 0.42, 0.26, 0.33, 2.6)))
    >>> float(leg.inertia)  # kg m^2
    0.42
    """

    mass: Inexact[Any, "*batch"] = parameter("m", "kg", 2.0, 6.0, "mass")
    inertia: Inexact[Any, "*batch"] = parameter("J", "kg m^2", 0.15, 1.0, "inertia about the knee")
    com_distance: Inexact[Any, "*batch"] = parameter("l", "m", 0.15, 0.6, "distance knee to COM")
    damping: Inexact[Any, "*batch"] = parameter("d", "N m s/rad", 0.0, 60.0, "damping")
    stiffness: Inexact[Any, "*batch"] = parameter("c", "N m/rad", 0.0, 4.0, "stiffness")

    def with_added_mass(
        self, mass: Float[Array, "*batch"], distance: Float[Array, "*batch"]
    ) -> "LegParameters":
        """The leg with a point mass [kg] fixed to it at `distance` [m] from the knee."""
        total = self.mass + mass
        return LegParameters(
            mass=total,
            inertia=self.inertia + mass * distance**2,
            com_distance=(self.mass * self.com_distance + mass * distance) / total,
            damping=self.damping,
            stiffness=self.stiffness,
        )


class LegModel(eqx.Module):
    """The leg and what drives it: J phi'' = tau_h(t) - m l g cos(phi) - c phi - d phi' (Eq. 9).

    On a seat that holds the thigh at an angle, gravity acts with cos(phi + thigh_angle). `terms`
    are what Eq. 9 leaves out: `exoid.physics.term`.

    >>> leg = exoid.LegParameters(*map(jnp.asarray, (4.5, 0.42, 0.26, 0.33, 2.6)))
    >>> exoid.LegModel(leg, exoid.NoTorque()).terms
    ()
    """

    leg: LegParameters
    torque: Torque
    thigh_angle: Float[Any, "*batch"] = field(
        default_factory=horizontal
    )  # rad, the knee above the hip
    terms: tuple[Any, ...] = ()  # each a Term

    def ratios(self) -> Ratios:
        """The coefficients of Eq. 9 per inertia."""
        leg = self.leg
        return Ratios(
            gravity=leg.mass * leg.com_distance * GRAVITY / leg.inertia,
            stiffness=leg.stiffness / leg.inertia,
            damping=leg.damping / leg.inertia,
            thigh_angle=self.thigh_angle,
        )


def angular_acceleration(
    ratios: Ratios, state: LegState, torque_over_inertia: Float[Array, "*batch"]
) -> Float[Array, "*batch"]:
    """phi'' of Eq. 9 [rad/s^2]."""
    return (
        torque_over_inertia
        - ratios.gravity * cos(state.angle + ratios.thigh_angle)
        - ratios.stiffness * state.angle
        - ratios.damping * state.angular_velocity
    )


def energy(model: LegModel, state: LegState) -> Float[Array, "*batch"]:
    """Kinetic, gravity and spring energy [J]: J phi'^2/2 + m l g sin(phi + thigh) + c phi^2/2."""
    leg = model.leg
    return (
        leg.inertia * state.angular_velocity**2 / 2
        + leg.mass * leg.com_distance * GRAVITY * jnp.sin(state.angle + model.thigh_angle)
        + leg.stiffness * state.angle**2 / 2
    )
