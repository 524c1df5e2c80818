"""Constraints g(leg, torque) <= 0, each with its unit and its reason (Eq. 12 and 13)."""

import equinox as eqx
import jax
import jax.numpy as jnp
from jaxtyping import Array, Float

from exoid.physics.leg import LegParameters


class Limits(eqx.Module):
    """Bounds of Eq. 13 and what holds for every rigid leg, m l^2 <= J <= reach m l.

    The left side is Eq. 12. The right side says that no part of the leg is farther from the knee
    than `reach`, so J = int r^2 dm <= reach int r dm. An infinite limit is no limit.
    """

    lower: LegParameters
    upper: LegParameters
    torque: Float[Array, ""]  # N m, greatest amplitude
    reach: Float[Array, ""]  # m


def violations(
    limits: Limits, leg: LegParameters, torque: Float[Array, " segment"]
) -> Float[Array, " constraint"]:
    """Every g, positive where violated, relative to the size of what it limits."""
    low = [
        jnp.where(jnp.isfinite(bound), (bound - value) / scale, NEVER)
        for bound, value, scale in zip(*map(jax.tree.leaves, (limits.lower, leg, SIZE)), strict=True)
    ]
    high = [
        jnp.where(jnp.isfinite(bound), (value - bound) / scale, NEVER)
        for bound, value, scale in zip(*map(jax.tree.leaves, (limits.upper, leg, SIZE)), strict=True)
    ]
    moment = leg.mass * leg.com_distance
    rigid = (moment * leg.com_distance - leg.inertia) / SIZE.inertia
    within = (leg.inertia - limits.reach * moment) / SIZE.inertia
    body = jnp.stack([rigid, jnp.where(jnp.isfinite(limits.reach), within, NEVER)])
    body = jnp.where(jnp.isfinite(limits.lower.mass), body, NEVER)
    drive = (jnp.abs(torque) - limits.torque) / SIZE_TORQUE
    drive = jnp.where(jnp.isfinite(limits.torque), drive, NEVER)
    return jnp.concatenate([jnp.stack(low), jnp.stack(high), body, drive])


SIZE = LegParameters(mass=1.0, inertia=0.1, com_distance=0.1, damping=0.1, stiffness=1.0)
SIZE_TORQUE = 10.0  # N m
NEVER = -1.0  # the g of a limit that is not there
