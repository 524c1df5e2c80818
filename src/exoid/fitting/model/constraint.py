"""Constraints g(leg, torque) <= 0, each with its unit and its reason (Eq. 12 and 13)."""

from dataclasses import fields
from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
from jaxtyping import Float, Inexact

from exoid.physics.leg import LegParameters


class Limits(eqx.Module):
    """Bounds as in Eq. 13 and what holds for every rigid leg, m l^2 <= J <= reach m l.

    The left side is Eq. 12. The right side says that no part of the leg is farther from the knee
    than `reach`, so J = int r^2 dm <= reach int r dm. An infinite limit is no limit. Where the two
    ends of a bound are one, the parameter is fixed.
    """

    lower: LegParameters
    upper: LegParameters
    torque: Float[Any, ""]  # N m, greatest amplitude
    reach: Float[Any, ""]  # m


def violations(
    limits: Limits, leg: LegParameters, torque: Inexact[Any, " segment *column"], xp=jnp
) -> Inexact[Any, " constraint *column"]:
    """Every g, positive where violated, relative to the size of what it limits.

    d and c are held by way of d / J and c / J: no search makes them small by a leg without inertia.
    """
    heavy = leg.inertia / MIDDLING
    size = [
        SIZE.mass,
        SIZE.inertia,
        SIZE.com_distance,
        heavy * SIZE.damping,
        heavy * SIZE.stiffness,
    ]
    values, lower, upper = (jax.tree.leaves(each) for each in (leg, limits.lower, limits.upper))
    low = [(bound - v) / unit for bound, v, unit in zip(lower, values, size, strict=True)]
    high = [(v - bound) / unit for bound, v, unit in zip(upper, values, size, strict=True)]
    moment = leg.mass * leg.com_distance
    # Eq. 12 and the reach are of a leg; on a rig, whose reach is infinite, m and l mean nothing.
    body = xp.isfinite(limits.reach)
    rigid = xp.where(body, (moment * leg.com_distance - leg.inertia) / SIZE.inertia, NEVER)
    within = (leg.inertia - limits.reach * moment) / SIZE.inertia
    every = xp.stack([*low, *high, rigid, within])
    drive = [(torque - limits.torque) / SIZE_TORQUE, (-torque - limits.torque) / SIZE_TORQUE]
    each = xp.concatenate([every, *drive])
    return xp.where(xp.isfinite(each), each, NEVER)


def constraint_names(segments: int) -> list[str]:
    """Which parameter each entry of `violations` limits, or the rule that it states."""
    parameters = [entry.name for entry in fields(LegParameters)]
    torques = [f"torque_amplitude[{number}]" for number in range(segments)]
    return [*parameters, *parameters, "m l^2 <= J", "J <= reach m l", *torques, *torques]


SIZE = LegParameters(*map(np.asarray, (1.0, 0.1, 0.1, 0.1, 1.0)))
SIZE_TORQUE = 10.0  # N m
MIDDLING = 0.4  # kg m^2: the inertia of the leg that these are of
NEVER = -1.0  # the g of a limit that is not there
