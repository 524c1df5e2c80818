"""One step of the leg by all that is unknown of it, and what the sensors show at its end."""

from typing import Any

import equinox as eqx
import jax.numpy as jnp
from jaxtyping import Array, Float

from exoid.online.model.sample import Sample
from exoid.online.model.unknowns import AT, Leg, Row, Unknowns
from exoid.physics.motion.step import Drive
from exoid.physics.motion.with_terms import (
    Motion,
    extended_step,
    friction,
    moment,
    observed,
    sticky,
)

# A loop is a wall to XLA, which else computes the step again in every kernel that uses some of it:
# two parts take half as long as one.
PARTS = 2


class Arrival(eqx.Module):
    """The leg at the end of a step, and what is seen of it there."""

    state: Float[Array, "2"]  # rad, rad/s
    shown: Float[Array, "2"]  # rad, rad/s
    acceleration: Float[Array, ""]  # rad/s^2
    rough: Float[Array, ""]  # rad/s, by which dry friction may be wrong where the leg turned round


def advance(unknowns: Unknowns, row: Row, sample: Sample, step: Any) -> Arrival:
    """From the row's motion on for `step` [s] to the sample."""
    leg = unknowns.leg(row, sample)
    push, place, terms = leg.push, leg.place, leg.terms
    start, begun = Motion(leg.state, tuple(jnp.zeros(0) for _ in terms)), sample.time - step
    end = extended_step(place, terms, start, begun, step, Drive(push, push, push), parts=PARTS)
    seen = observed(place, terms, end, sample.time, push)
    late = seen.delay + row[AT["gyro_delay"]]
    rate = seen.shown_velocity - late * seen.shown_acceleration
    turning = (1 + row[AT["gyro_scale"]]) * rate + row[AT["gyro_bias"]]
    return Arrival(
        jnp.stack([end.leg.angle + leg.turned, end.leg.angular_velocity]),
        jnp.stack([seen.shown_angle + leg.turned, turning]),
        seen.angular_acceleration,
        roughness(unknowns, leg, end, step),
    )


def roughness(unknowns: Unknowns, leg: Leg, end: Motion, step: Any) -> Float[Array, ""]:
    """Friction turns round at an instant of its own, and is followed part by part of a step."""
    if not sticky(leg.terms):
        return jnp.zeros(())
    parts = max(PARTS, *(term.substeps for term in unknowns.terms))
    level = friction(leg.terms, moment(leg.place, end.leg, step, leg.push)) / leg.place.inertia
    turned = leg.state.angular_velocity * end.leg.angular_velocity <= 0
    return jnp.where(turned, jnp.abs(level) * step / parts, 0.0)
