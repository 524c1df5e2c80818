"""The coordinates in which a fit moves: what motion can tell, apart from what it cannot.

Motion fixes m l g / J, c / J, d / J and tau / J (exactly; scaling m, J, d, c and tau together
changes nothing). The inertia matters only beside a known mass or torque, the mass never.
"""

from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
from jax.flatten_util import ravel_pytree
from jaxtyping import Float, Inexact, Int, Num

from exoid.physics.leg import GRAVITY, LegParameters

QUANTITIES = 8  # of the leg that a fit reports; two more of every segment


class Shared(eqx.Module):
    """What the leg owns and motion can tell."""

    log_inertia: Float[Any, "*batch"]  # log(J / kg m^2)
    gravity: Float[Any, "*batch"]  # m l g / J, 1/s^2
    stiffness: Float[Any, "*batch"]  # c / J, 1/s^2
    damping: Float[Any, "*batch"]  # d / J, 1/s


class Mounting(eqx.Module):
    """What a recording owns: by how much sensors, seat and added mass differ from what is declared.

    A leaf without entries is no unknown of this fit: everything is as declared.
    """

    log_distance: Float[Any, "..."]  # log(distance of the added mass over the declared one)
    log_added: Float[Any, "..."]  # log(added mass over the declared one)
    extent: Float[Any, "..."]  # m^2, its squared radius of gyration less the declared one
    zero: Float[Any, "..."]  # rad, what the encoder shows with the knee extended
    tilt: Float[Any, "..."]  # rad, of the thigh beyond the declared angle
    gyro_scale: Float[Any, "..."]  # relative, less 1
    gyro_bias: Float[Any, "..."]  # rad/s
    clock: Float[Any, "..."]  # relative: true seconds in a recorded one, less 1


class Own(eqx.Module):
    """What a segment owns."""

    torque: Float[Any, "*segment"]  # tau / J, 1/s^2
    angle: Float[Any, "*segment"]  # rad, at the segment's first sample
    angular_velocity: Float[Any, "*segment"]  # rad/s


class Coordinates(eqx.Module):
    """A point of the fit; `own` carries an axis `segment`."""

    shared: Shared
    log_mass: Float[Any, "*batch"]  # log(m / kg)
    mounting: Mounting
    own: Own


TYPICAL = Coordinates(
    Shared(*map(np.asarray, (0.3, 10.0, 3.0, 1.0))),
    np.asarray(0.3),
    Mounting(*map(np.asarray, (0.1, 0.01, 0.003, 0.05, 0.05, 0.05, 0.02, 0.01))),
    Own(*map(np.asarray, (10.0, 0.1, 0.5))),
)  # a step of order one


def scaled(coordinates: Coordinates) -> Coordinates:
    """In units of `TYPICAL`: what the solver sees."""
    return jax.tree.map(lambda value, unit: value / unit, coordinates, TYPICAL)


def unscaled(coordinates: Coordinates) -> Coordinates:
    """Back from units of `TYPICAL`."""
    return jax.tree.map(lambda value, unit: value * unit, coordinates, TYPICAL)


def flattened(coordinates: Coordinates) -> np.ndarray:
    """All entries in one row."""
    return np.concatenate([np.ravel(leaf) for leaf in jax.tree.leaves(coordinates)])


def unflattened(values: np.ndarray, like: Coordinates) -> Coordinates:
    """`flattened` undone; `values` may carry further axes behind."""
    leaves, structure = jax.tree.flatten(like)
    parts = np.split(values, np.cumsum([np.size(leaf) for leaf in leaves])[:-1])
    shaped = [
        part.reshape((*np.shape(leaf), *values.shape[1:]))
        for part, leaf in zip(parts, leaves, strict=True)
    ]
    return jax.tree.unflatten(structure, shaped)


def seated(mounting: Mounting, seat: Int[Any, ""]) -> Mounting:
    """The entries of one segment, which belongs to recording `seat`: each leaf of length one, or
    none where it is no unknown.
    """
    return jax.tree.map(lambda leaf: leaf[seat][None] if leaf.size else leaf, mounting)


def by_segment(
    point: Coordinates, seat: Int[Any, " segment"], xp=jnp
) -> Num[Any, "segment unknown"]:
    """The unknowns of every segment in one row: what the leg, its recording and itself own."""
    count = point.own.angle.shape[0]
    shared = [xp.broadcast_to(leaf, (count,)) for leaf in jax.tree.leaves(point.shared)]
    mounting = [leaf[seat] for leaf in jax.tree.leaves(point.mounting) if leaf.size]
    return xp.stack([*shared, *mounting, *jax.tree.leaves(point.own)], axis=1)


def in_a_row(unknowns: tuple[Shared, Mounting, Own]):
    """The unknowns of one segment in a row, in units of `TYPICAL`, and the way back."""
    point, unravel = ravel_pytree(unknowns)
    typical = (TYPICAL.shared, TYPICAL.mounting, TYPICAL.own)
    unit, _ = ravel_pytree(jax.tree.map(jnp.full_like, unknowns, typical))
    return point / unit, lambda row: unravel(row * unit)


def quantities(coordinates: Coordinates, xp=jnp) -> Inexact[Any, " quantity *column"]:
    """What a fit reports: m, J, l, d, c, m l g / J, c / J, d / J; of each segment tau, tau / J."""
    shared, own = coordinates.shared, coordinates.own
    leg = jax.tree.leaves(leg_parameters(coordinates, xp))
    common = xp.stack([*leg, shared.gravity, shared.stiffness, shared.damping])
    return xp.concatenate([common, torque_amplitudes(coordinates, xp), own.torque])


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
