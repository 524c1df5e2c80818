"""A step of Eq. 9 with what it leaves out."""

from functools import partial
from typing import Any

import jax
import jax.numpy as jnp

from exoid.physics.moment import SegmentConstants
from exoid.physics.motion.contact import CLOSE, met, until_contact
from exoid.physics.motion.step import Drive, parabola, rk4
from exoid.physics.motion.with_terms import (
    Motion,
    Terms,
    friction,
    gaps,
    holds_still,
    moment,
    slopes,
    sticky,
)
from exoid.physics.state import LegState
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
    parts: int = 1,
    compact: bool = False,
) -> Motion:
    """The step from `time` on, in so many `parts` or as many as the fastest term asks for, each of
    them `compact` (`rk4`) or not.

    A part in which something meets ends there, and the next is longer. Dry friction acts in half
    steps before and after the smooth rest (Strang splitting): it can bring the leg to rest, but
    never turn it round.
    """
    parts = max([parts, *(term.substeps for term in terms)])
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
    dry, free, held = sticky(terms), jnp.ones(()), jnp.zeros((), bool)

    def rate(at: Motion, part: Any) -> Motion:
        push = parabola(drive.begin, drive.middle, drive.end, part) if compact else pushes[part]
        return slopes(place, terms, at, time + part * step, push, free)

    if dry:
        begun = slowed(place, terms, motion, time, step / 2, drive.begin)
        held = holds_still(place, terms, begun, time, drive.begin)
        free = jnp.where((begun.leg.angular_velocity == 0) & held, 0.0, 1.0)
        motion = passing(motion, begun, held)
    motion = rk4(rate, motion, step, compact=compact)
    if dry:
        ended = slowed(place, terms, motion, time + step, step / 2, drive.end)
        motion = passing(motion, ended, held)
    now = moment(place, motion.leg, time + step, drive.end)
    kept = tuple(
        term.memory_within(now, own) for term, own in zip(terms, motion.memory, strict=True)
    )
    return Motion(motion.leg, kept)


def slowed(
    place: SegmentConstants, terms: Terms, motion: Motion, time: Any, step: Any, push: Any
) -> Motion:
    """phi' <- sgn(phi') max(0, |phi'| - step F / J)."""
    leg = motion.leg
    level = friction(terms, moment(place, leg, time, push)) / place.inertia
    left = jnp.maximum(jnp.abs(leg.angular_velocity) - step * level, 0.0)
    return Motion(LegState(leg.angle, jnp.sign(leg.angular_velocity) * left), motion.memory)


def passing(before: Motion, after: Motion, held: Any) -> Motion:
    """`after`, with the slopes of `before` where friction took all of the velocity from a leg that
    it does not hold: that passes through zero, and forgets nothing of how it moved.
    """
    rate, left = before.leg.angular_velocity, after.leg.angular_velocity
    passes = (left == 0) & ~held
    through = jnp.where(passes, rate - jax.lax.stop_gradient(rate), left)
    return Motion(LegState(after.leg.angle, through), after.memory)
