"""A step of Eq. 9 with what it leaves out."""

from functools import partial
from typing import Any

import jax
import jax.numpy as jnp
from jaxtyping import Array, Float

from exoid.physics.moment import SegmentConstants
from exoid.physics.motion.contact import CLOSE, met, until_contact
from exoid.physics.motion.dry_friction import sense_of, turned
from exoid.physics.motion.parts_of_a_step import most_parts
from exoid.physics.motion.step import Drive, parabola, rk4
from exoid.physics.motion.with_terms import (
    Motion,
    Terms,
    gaps,
    moment,
    pulled,
    rubbed,
    slopes,
    sticks,
    sticky,
)
from exoid.physics.term import strikes

FEWEST = 3  # parts of a step in which something may meet


def extended_step(
    place: SegmentConstants,
    terms: Terms,
    motion: Motion,
    time: Any,
    step: Any,
    drive: Drive,
    *,
    parts: int | None = None,
    compact: bool = False,
) -> Motion:
    """The step from `time` on, in so many `parts`, or as many as the fastest term asks for of the
    longest step, each of them `compact` (`rk4`) or not.

    A part in which something meets ends there, and the next is longer.
    """
    parts = parts or most_parts([*map(type, terms)])
    meeting = any(strikes(type(term)) for term in terms)
    parts = max(parts, FEWEST) if meeting else parts
    if parts == 1:
        return whole_step(place, terms, motion, time, step, drive, compact=compact)
    stages = (drive.begin, drive.middle, drive.end)

    def piece(place, motion, begin, share):
        """From a fraction of the step on, so large a share of it."""
        pushes = Drive(*(parabola(*stages, begin + at * share) for at in (0.0, 0.5, 1.0)))
        begun = time + begin * step
        return whole_step(place, terms, motion, begun, share * step, pushes, compact=compact)

    def part_of(number, motion):
        return piece(place, motion, number / parts, 1 / parts)

    def part_to_contact(number, carry):
        motion, begin = carry
        end = jnp.minimum((number + 1) / (parts - 1), 1.0)  # the last is for what met before it

        def apart(motion, begin):
            return gaps(place, terms, motion, time + begin * step, parabola(*stages, begin))

        def rate(slack, motion, begin):
            now, push = time + begin * step, parabola(*stages, begin)
            return slopes(place.with_slack(slack), terms, motion, now, push, jnp.ones(()))

        still = jax.lax.stop_gradient
        seen = partial(apart, begin=begin), partial(rate, place.slack, begin=begin)
        ahead = still(until_contact(*seen, still(motion), step) / step)
        meets = (begin + ahead < end) & (number < parts - 1)
        share = jnp.where(meets, ahead, end - begin)
        slack = jnp.where(meets, -CLOSE, CLOSE)
        motion = piece(place.with_slack(slack), motion, begin, share)
        begin = begin + share
        later = met(partial(apart, begin=begin), partial(rate, begin=begin), motion)
        return jax.tree.map(lambda a, b: jnp.where(meets, a, b), later, motion), begin

    if meeting:
        return jax.lax.fori_loop(0, parts, part_to_contact, (motion, jnp.zeros(())))[0]
    return jax.lax.fori_loop(0, parts, part_of, motion)


def whole_step(
    place: SegmentConstants,
    terms: Terms,
    motion: Motion,
    time: Any,
    step: Any,
    drive: Drive,
    *,
    compact: bool,
) -> Motion:
    place = place.with_step(step)
    pushes = {0.0: drive.begin, 0.5: drive.middle, 1.0: drive.end}
    dry, begin = sticky(terms), motion
    free, sense = way(place, terms, motion, time, drive.begin) if dry else (jnp.ones(()), None)

    def rate(at: Motion, part: Any) -> Motion:
        push = parabola(drive.begin, drive.middle, drive.end, part) if compact else pushes[part]
        return slopes(place, terms, at, time + part * step, push, free, sense)

    motion = rk4(rate, motion, step, compact=compact)
    if dry:
        levels = (
            rubbed(place, terms, begin, time, drive.begin),
            rubbed(place, terms, motion, time + step, drive.end),
        )
        leg = turned(begin.leg, motion.leg, sense, levels, step)
        motion = Motion(leg, motion.memory)
    now = moment(place, motion.leg, time + step, drive.end)
    kept = tuple(
        term.memory_within(now, own) for term, own in zip(terms, motion.memory, strict=True)
    )
    return Motion(motion.leg, kept)


def way(
    place: SegmentConstants, terms: Terms, motion: Motion, time: Any, push: Any
) -> tuple[Float[Array, ""], Float[Array, ""]]:
    """Whether it is free to move, 1 or 0, and which way it goes."""
    now = place, terms, motion, time, push
    sense = sense_of(motion.leg.angular_velocity, pulled(*now))
    return jnp.where(sticks(*now), 0.0, 1.0), sense
