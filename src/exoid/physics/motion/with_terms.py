"""Eq. 9 with what it leaves out: terms that push, stick, remember, or show another motion."""

from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
from jaxtyping import Array, Float

from exoid.physics.leg import angular_acceleration
from exoid.physics.moment import Moment, SegmentConstants
from exoid.physics.motion.step import Drive, parabola, rk4
from exoid.physics.state import LegState
from exoid.physics.term import Reading, Term, holds, reading, strikes

CLOSE = 1e-6  # rad: where a contact was foreseen, it closes
Terms = tuple[Term, ...]


class Motion(eqx.Module):
    """The leg's state and that of every term."""

    leg: LegState
    memory: tuple[Array, ...]


class ObservedMotion(eqx.Module):
    """A motion and what the sensors show of it."""

    angle: Float[Any, "*time"]  # rad
    angular_velocity: Float[Any, "*time"]  # rad/s
    angular_acceleration: Float[Any, "*time"]  # rad/s^2, terms included
    shown_angle: Float[Any, "*time"]  # rad
    shown_velocity: Float[Any, "*time"]  # rad/s, before the gyro's delay
    shown_acceleration: Float[Any, "*time"]  # rad/s^2
    delay: Float[Any, "*time"]  # s


def moment(place: SegmentConstants, leg: LegState, time: Any, push: Any) -> Moment:
    """The instant at which a torque per inertia `push` [rad/s^2] drives the leg."""
    acceleration = angular_acceleration(place.ratios, leg, push)
    return Moment(time, leg.angle, leg.angular_velocity, acceleration, place)


def at_rest(place: SegmentConstants, terms: Terms, leg: LegState, time: Any, push: Any) -> Motion:
    """The motion as it begins, every term at rest."""
    now = moment(place, leg, time, push)
    return Motion(leg, tuple(term.memory_at_rest(now) for term in terms))


def missing(terms: Terms, now: Moment, memory: tuple[Array, ...]) -> Float[Array, "*batch"]:
    """The terms' torque per inertia [rad/s^2], but for dry friction.

    What changes the leg's inertia acts on all that moves it, the other terms' torques included.
    """
    if not terms:
        return jnp.zeros(())
    pushed = now.angular_acceleration
    for inertial in (False, True):
        at = eqx.tree_at(lambda now: now.angular_acceleration, now, pushed)
        torques = [
            term.torque(at, own)
            for term, own in zip(terms, memory, strict=True)
            if term.inertial is inertial
        ]
        pushed = pushed + sum(torques, jnp.zeros(())) / now.inertia
    return pushed - now.angular_acceleration


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

    Where something can meet, parts are done in twos: until it does, and from then on. Dry friction
    acts in half steps before and after the smooth rest (Strang splitting): it can bring the leg to
    rest, but never turn it round.
    """
    parts = max([parts, *(term.substeps for term in terms)])
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

    def parted(number, motion):
        begin, share = 2 * number / parts, 2 / parts
        push = parabola(*stages, begin)
        until = contact(place, terms, motion, time + begin * step, share * step, push) / step
        meets = until < share
        first = jnp.where(meets, until, share / 2)

        def half(after, motion):
            slack = jnp.where(meets, jnp.where(after, CLOSE, -CLOSE), place.slack)
            here = eqx.tree_at(lambda place: place.slack, place, slack)
            return piece(
                here,
                motion,
                begin + after * first,
                jnp.where(after, share - first, first),
            )

        return jax.lax.fori_loop(0, 2, half, motion)

    if any(strikes(type(term)) for term in terms):
        return jax.lax.fori_loop(0, (parts + 1) // 2, parted, motion)
    return jax.lax.fori_loop(0, parts, part_of, motion)


def contact(
    place: SegmentConstants, terms: Terms, motion: Motion, time: Any, step: Any, push: Any
) -> Float[Array, ""]:
    """The time [s] until something meets, by speed and acceleration of its gap; at most `step`."""
    slope = slopes(place, terms, motion, time, push, jnp.ones(()))
    ahead = jax.tree.map(lambda now, rate: now + step * rate, motion, slope)

    def gaps(motion: Motion):
        now = moment(place, motion.leg, time, push)
        each = zip(terms, motion.memory, strict=True)
        return jnp.concatenate([term.gaps(now, memory) for term, memory in each]).T

    (gap, opening), (_, later) = gaps(motion), gaps(ahead)
    under = opening**2 - 2 * gap * (later - opening) / step
    root = jnp.sqrt(jnp.where(under > 0, under, 1.0))
    meets = (gap > 0) & (under > 0) & (root > opening)
    until = jnp.where(meets, 2 * gap / jnp.where(meets, root - opening, 1.0), step)
    return jnp.minimum(until.min(), step)


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


@jax.jit  # traced once, for all stages of a step
def slopes(
    place: SegmentConstants, terms: Terms, at: Motion, time: Any, push: Any, free: Any
) -> Motion:
    """The time derivatives of leg and terms; `free` is 0 while the leg sticks."""
    now = moment(place, at.leg, time, push)
    pulled = now.angular_acceleration
    if terms:
        pulled = pulled + missing(terms, now, at.memory)
    moving = LegState(at.leg.angular_velocity, pulled)
    if sticky(terms):
        moving = jax.tree.map(lambda slope: free * slope, moving)
    changes = tuple(term.memory_rate(now, own) for term, own in zip(terms, at.memory, strict=True))
    return Motion(moving, changes)


def sticky(terms: Terms) -> bool:
    """Does any of them hold a leg at rest?"""
    return any(holds(type(term)) for term in terms)


def sticks(place: SegmentConstants, terms: Terms, motion: Motion, time: Any, push: Any):
    """Does the leg stand still, with more friction than what pulls at it?"""
    still = motion.leg.angular_velocity == 0
    return still & holds_still(place, terms, motion, time, push)


def holds_still(place: SegmentConstants, terms: Terms, motion: Motion, time: Any, push: Any):
    """Is there more friction than what pulls at the leg?"""
    now = moment(place, motion.leg, time, push)
    pulled = now.angular_acceleration + missing(terms, now, motion.memory)
    level = friction(terms, now)
    return (jnp.abs(pulled) * now.inertia <= level) & (level > 0)


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


def friction(terms: Terms, now: Moment) -> Float[Array, "*batch"]:
    """The level of dry friction [N m]."""
    return sum([term.dry_friction(now) for term in terms], jnp.zeros(()))


def observed(
    place: SegmentConstants, terms: Terms, motion: Motion, time: Any, push: Any
) -> ObservedMotion:
    """What the sensors show of an instant, but for the gyro's delay."""
    leg = motion.leg
    now = moment(place, leg, time, push)
    acceleration = now.angular_acceleration
    if terms:
        acceleration = acceleration + missing(terms, now, motion.memory)
    if sticky(terms):
        opposed = jnp.sign(leg.angular_velocity) * friction(terms, now) / place.inertia
        held = sticks(place, terms, motion, time, push)
        acceleration = jnp.where(held, 0.0, acceleration - opposed)
    error = errors(terms, now, motion.memory)
    return ObservedMotion(
        angle=leg.angle,
        angular_velocity=leg.angular_velocity,
        angular_acceleration=acceleration,
        shown_angle=leg.angle + error.angle,
        shown_velocity=leg.angular_velocity + error.angular_velocity,
        shown_acceleration=acceleration,
        delay=error.delay,
    )


def errors(terms: Terms, now: Moment, memory: tuple[Array, ...]) -> Reading:
    """What the sensors show minus how the leg moves."""
    each = [term.shown(now, own) for term, own in zip(terms, memory, strict=True)]
    return sum(each, reading(jnp.zeros_like(now.angle)))


def delayed(
    time: Any, value: Any, slope: Any, delay: Any, last: Any = None
) -> Float[Array, " time"]:
    """A rate as it was `delay` [s] before, by cubic Hermite interpolation between samples.

    Beyond its ends (`last`) it goes on along the tangent; before the first, a leg let go rested.
    """
    wanted, end = time - delay, time.size - 1 if last is None else last
    after = jnp.clip(jnp.searchsorted(time, wanted), 1, end)
    before, step = after - 1, time[after] - time[after - 1]
    x = jnp.clip((wanted - time[before]) / step, 0.0, 1.0)
    beyond = wanted - (time[before] + x * step)
    rise = value[after] - value[before]
    bend_first, bend_last = step * slope[before] - rise, rise - step * slope[after]
    inside = value[before] + x * rise + x * (1 - x) * ((1 - x) * bend_first + x * bend_last)
    change = beyond * jnp.where(x > 0.5, slope[after], slope[before])
    back, gain = inside * jnp.sign(change), jnp.abs(slope[before]) * step
    begun = (beyond < 0) & (-jnp.abs(change) <= back) & (back <= gain)  # within that sample's step
    return jnp.where(begun, 0.0, inside + change)
