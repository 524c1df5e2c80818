"""One step of the leg by all that is unknown of it, and what the sensors show at its end."""

from typing import Any

import equinox as eqx
import jax.numpy as jnp
from jaxtyping import Array, Float

from exoid.online.model.sample import Sample
from exoid.online.model.unknowns import AT, Leg, Row, Unknowns
from exoid.physics.motion.extended_step import extended_step
from exoid.physics.motion.parts_of_a_step import most_parts
from exoid.physics.motion.step import Drive
from exoid.physics.motion.with_terms import (
    Motion,
    friction,
    moment,
    observed,
    sticky,
)

# A loop is a wall to XLA, which else computes the step again in every kernel that uses some of it:
# two parts take half as long as one.
PARTS = 2


class Span(eqx.Module):
    """The time from one sample to the next."""

    length: Float[Any, ""]  # s
    torque: Float[Any, ""]  # N m, known, at its begin


class Arrival(eqx.Module):
    """The leg at the end of a step."""

    state: Float[Array, "2"]  # rad, rad/s: the encoder's angle
    rough: Float[Array, ""]  # rad/s, by which dry friction may be wrong where the leg turned round


class View(eqx.Module):
    """What the sensors show of a row."""

    shown: Float[Array, "2"]  # rad, rad/s
    acceleration: Float[Array, ""]  # rad/s^2


def advance(unknowns: Unknowns, row: Row, sample: Sample, span: Span) -> Arrival:
    """From the row's motion on to the sample; a torque is linear in between."""
    leg, step = unknowns.leg(row, sample), span.length
    start, begun = Motion(leg.state, tuple(jnp.zeros(0) for _ in leg.terms)), sample.time - step
    first = leg.push + (span.torque - sample.torque) / leg.place.inertia
    drive = Drive(first, (first + leg.push) / 2, leg.push)
    end = extended_step(leg.place, leg.terms, start, begun, step, drive, parts=parts_of(leg))
    state = jnp.stack([end.leg.angle + leg.turned, end.leg.angular_velocity])
    return Arrival(state, roughness(leg, end, step))


def view(unknowns: Unknowns, row: Row, sample: Sample) -> View:
    """What encoder and gyro show of the row's motion."""
    leg = unknowns.leg(row, sample)
    motion = Motion(leg.state, tuple(jnp.zeros(0) for _ in leg.terms))
    seen = observed(leg.place, leg.terms, motion, sample.time, leg.push)
    late = seen.delay + row[AT["gyro_delay"]]
    rate = seen.shown_velocity - late * seen.shown_acceleration
    turning = (1 + row[AT["gyro_scale"]]) * rate + row[AT["gyro_bias"]]
    shown = jnp.stack([seen.shown_angle + leg.turned, turning])
    return View(shown, seen.angular_acceleration)


def parts_of(leg: Leg) -> int:
    """Of a step."""
    return max(PARTS, most_parts([*map(type, leg.terms)]))


def roughness(leg: Leg, end: Motion, step: Any) -> Float[Array, ""]:
    """Friction turns round at an instant that nobody is sure of: it may be a part of a step off."""
    if not sticky(leg.terms):
        return jnp.zeros(())
    level = friction(leg.terms, moment(leg.place, end.leg, step, leg.push)) / leg.place.inertia
    turned = leg.state.angular_velocity * end.leg.angular_velocity <= 0
    return jnp.where(turned, jnp.abs(level) * step / parts_of(leg), 0.0)
