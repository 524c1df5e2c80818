"""What terms remember at the first state of a leg that was let go at rest."""

from typing import Any

import jax
import jax.numpy as jnp
from jaxtyping import Array, Float

from exoid.physics.moment import SegmentConstants
from exoid.physics.motion.extended_step import extended_step
from exoid.physics.motion.step import Drive
from exoid.physics.motion.with_terms import (
    Motion,
    Terms,
    at_rest,
    pulled,
    rubbed,
)
from exoid.physics.state import LegState

LONGEST = 0.1  # s from the release to the first state
STEPS = 16  # of the fall, none longer than a sample's
CORRECTIONS = 4  # of where it began and how long it lasted
STILL = 1e-3  # rad/s^2: what is pulled by less does not fall
REACHED = 0.03  # rad and rad/s, by which a fall may miss the state


def after_release(
    place: SegmentConstants, terms: Terms, leg: LegState, time: Any, push: Any
) -> Motion:
    """The motion at a first state, its memory what the fall from rest to there left.

    Where the fall began, and how long it lasted, follow from the state by Newton's method. Where no
    fall within `LONGEST` leads there, the leg began in motion: the terms are at rest with it.
    """
    standing = at_rest(place, terms, leg, time, push)
    if not any(term.memory_size for term in terms):
        return standing
    drive = Drive(push, push, push)

    def fallen(begin: Array, lasted: Array) -> Motion:
        step, released = lasted / STEPS, time - lasted

        def part(number, motion):
            begun = released + number * step
            return extended_step(place, terms, motion, begun, step, drive, compact=True)

        held = LegState(begin, jnp.zeros_like(begin))
        return jax.lax.fori_loop(0, STEPS, part, at_rest(place, terms, held, released, push))

    def corrected(_, fall):
        begin, lasted, _ = fall
        motion = fallen(begin, lasted)
        reached = motion.leg
        pull = acceleration(place, terms, motion, time, push)
        slope = jnp.where(jnp.abs(pull) > STILL, pull, STILL)
        faster = (leg.angular_velocity - reached.angular_velocity) / slope
        after = jnp.clip(lasted + faster, 0.0, LONGEST)
        begin = begin + leg.angle - reached.angle - (after - lasted) * reached.angular_velocity
        return begin, after, motion

    at_once = leg.angle, jnp.zeros_like(leg.angle), standing
    motion = jax.lax.fori_loop(0, CORRECTIONS + 1, corrected, at_once)[-1]
    near = jax.tree.map(lambda one, other: jnp.abs(one - other) < REACHED, motion.leg, leg)
    there = near.angle & near.angular_velocity
    memory = jax.tree.map(
        lambda fell, stood: jnp.where(there, fell, stood), motion.memory, standing.memory
    )
    return Motion(leg, memory)


def acceleration(
    place: SegmentConstants, terms: Terms, motion: Motion, time: Any, push: Any
) -> Float[Array, ""]:
    """Of a leg that moves the way it is pulled [rad/s^2]."""
    pull = pulled(place, terms, motion, time, push)
    left = jnp.abs(pull) - rubbed(place, terms, motion, time, push)
    return jnp.sign(pull) * jnp.maximum(left, 0.0)
