"""Constraints g(leg, torque) <= 0, each with its unit and its reason (Eq. 12 and 13)."""

from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
from jaxtyping import Inexact

from exoid.fitting.model.coordinates import (
    Coordinates,
    leg_parameters,
    torque_amplitudes,
    with_inertia,
)
from exoid.fitting.model.limits import Limits
from exoid.fitting.model.term_parameters import typical_term
from exoid.physics.leg import LegParameters


def violations_at(limits: Limits, point: Coordinates, xp=jnp):
    """Every g of the leg's limits at a point of the fit, then of the terms' own."""
    torque = torque_amplitudes(point, xp)
    of_leg = violations(limits, leg_parameters(point, xp), torque, xp)
    return xp.concatenate([of_leg, term_violations(limits, point, xp)])


def term_violations(limits: Limits, point: Coordinates, xp=jnp):
    """Every g of what the terms' parameters can be, relative to a step of order one."""
    if not point.terms:
        return xp.zeros((0, *xp.shape(point.log_mass)))
    sizes = jax.tree.leaves(tuple(typical_term(type(term)) for term in point.terms))
    ends = limits.lower_terms, limits.upper_terms
    each = xp.stack(beyond(with_inertia(point, xp), *ends, sizes))
    return xp.where(xp.isfinite(each), each, NEVER)


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
    moment = leg.mass * leg.com_distance
    # Eq. 12 and the reach are of a leg; on a rig, whose reach is infinite, m and l mean nothing.
    body = xp.isfinite(limits.reach)
    rigid = xp.where(body, (moment * leg.com_distance - leg.inertia) / SIZE.inertia, NEVER)
    reach = xp.where(body, limits.reach, 0.0)  # a rig without gravity has no moment either
    within = xp.where(body, (leg.inertia - reach * moment) / SIZE.inertia, NEVER)
    every = xp.stack([*beyond(leg, limits.lower, limits.upper, size), rigid, within])
    drive = [(torque - limits.torque) / SIZE_TORQUE, (-torque - limits.torque) / SIZE_TORQUE]
    each = xp.concatenate([every, *drive])
    return xp.where(xp.isfinite(each), each, NEVER)


def beyond(values: Any, lower: Any, upper: Any, sizes: list) -> list:
    """How far every leaf is below its lower and above its upper end, in units of its size."""
    leaves = list(zip(*map(jax.tree.leaves, (values, lower, upper)), sizes, strict=True))
    low = [(least - value) / size for value, least, _, size in leaves]
    return low + [(value - most) / size for value, _, most, size in leaves]


SIZE = LegParameters(*map(np.asarray, (1.0, 0.1, 0.1, 0.1, 1.0)))
SIZE_TORQUE = 10.0  # N m
MIDDLING = 0.4  # kg m^2: the inertia of the leg that these are of
NEVER = -1.0  # the g of a limit that is not there
