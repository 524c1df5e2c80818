"""What terms remember at the first state of a leg that was let go at rest."""

from typing import Any

import jax
import jax.numpy as jnp
from jaxtyping import Array, Float

from exoid.physics.moment import Place
from exoid.physics.motion.step import Drive
from exoid.physics.motion.with_terms import (
    Motion,
    Terms,
    at_rest,
    extended_step,
    friction,
    missing,
    moment,
)
from exoid.physics.state import LegState

FALL = (-0.02, 0.1)  # s, from the release to the first state; one before it was simulated early
STEPS = 8  # of the fall
CORRECTIONS = 4  # of where it began and how long it lasted
STILL = 1e-3  # rad/s^2: what is pulled by less does not fall


def let_go(place: Place, terms: Terms, leg: LegState, time: Any, push: Any) -> Motion:
    """The motion at a first state, its memory what the fall from rest to there left.

    Where the fall began, and how long it lasted, follow from the state by Newton's method.
    """
    if not any(term.memory_size for term in terms):
        return at_rest(place, terms, leg, time, push)
    drive = Drive(push, push, push)

    def fallen(begin: Array, lasted: Array) -> Motion:
        def part(_, motion):
            return extended_step(place, terms, motion, time, lasted / STEPS, drive)

        held = at_rest(place, terms, LegState(begin, jnp.zeros_like(begin)), time, push)
        return jax.lax.fori_loop(0, STEPS, part, held)

    def corrected(_, fall):
        begin, lasted = fall
        motion = fallen(begin, lasted)
        reached = motion.leg
        pulled = acceleration(place, terms, motion, time, push)
        slope = jnp.where(jnp.abs(pulled) > STILL, pulled, STILL)
        longer = (leg.angular_velocity - reached.angular_velocity) / slope
        begin = begin + leg.angle - reached.angle - longer * reached.angular_velocity
        return begin, jnp.clip(lasted + longer, *FALL)

    at_once = leg.angle, jnp.zeros_like(leg.angle)
    fall = jax.lax.fori_loop(0, CORRECTIONS, corrected, at_once)
    return Motion(leg, fallen(*fall).memory)


def acceleration(
    place: Place, terms: Terms, motion: Motion, time: Any, push: Any
) -> Float[Array, ""]:
    """Of a leg that moves the way it is pulled [rad/s^2]."""
    now = moment(place, motion.leg, time, push)
    pulled = now.angular_acceleration + missing(terms, now, motion.memory)
    slowed = jnp.abs(pulled) - friction(terms, now) / place.inertia
    return jnp.sign(pulled) * jnp.maximum(slowed, 0.0)
