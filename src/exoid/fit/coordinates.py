"""The coordinates in which a fit moves: what motion can tell, apart from what it cannot.

Motion fixes m l g / J, c / J, d / J and tau / J (exactly; scaling m, J, d, c and tau together
changes nothing). The inertia matters only beside a known mass or torque, the mass never.
"""

from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
from jaxtyping import Float, Inexact

from exoid.physics.leg import GRAVITY, LegParameters


class Shared(eqx.Module):
    """What the leg owns and motion can tell."""

    log_inertia: Float[Any, "*batch"]  # log(J / kg m^2)
    gravity: Float[Any, "*batch"]  # m l g / J, 1/s^2
    stiffness: Float[Any, "*batch"]  # c / J, 1/s^2
    damping: Float[Any, "*batch"]  # d / J, 1/s


class Own(eqx.Module):
    """What a segment owns."""

    torque: Float[Any, "*segment"]  # tau / J, 1/s^2
    angle: Float[Any, "*segment"]  # rad, at the segment's first sample
    angular_velocity: Float[Any, "*segment"]  # rad/s


class Coordinates(eqx.Module):
    """A point of the fit; `own` carries an axis `segment`."""

    shared: Shared
    log_mass: Float[Any, "*batch"]  # log(m / kg)
    own: Own


TYPICAL = Coordinates(
    Shared(*map(np.asarray, (0.3, 10.0, 3.0, 1.0))),
    np.asarray(0.3),
    Own(*map(np.asarray, (10.0, 0.1, 0.5))),
)  # a step of order one


def scaled(coordinates: Coordinates) -> Coordinates:
    """In units of `TYPICAL`: what the solver sees."""
    return jax.tree.map(lambda value, unit: value / unit, coordinates, TYPICAL)


def unscaled(coordinates: Coordinates) -> Coordinates:
    """Back from units of `TYPICAL`."""
    return jax.tree.map(lambda value, unit: value * unit, coordinates, TYPICAL)


def leg_parameters(coordinates: Coordinates, xp=jnp) -> LegParameters:
    """P without the torque: l from m l g / J, the rest directly; `xp` is jax.numpy or numpy."""
    shared = coordinates.shared
    inertia, mass = xp.exp(shared.log_inertia), xp.exp(coordinates.log_mass)
    return LegParameters(
        mass=mass,
        inertia=inertia,
        com_distance=shared.gravity * inertia / (mass * GRAVITY),
        damping=shared.damping * inertia,
        stiffness=shared.stiffness * inertia,
    )


def torque_amplitudes(coordinates: Coordinates, xp=jnp) -> Inexact[Any, "*segment"]:
    """tau of Eq. 10 in every segment [N m]."""
    return coordinates.own.torque * xp.exp(coordinates.shared.log_inertia)
