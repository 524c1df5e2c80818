"""Eq. 9 with what it leaves out: terms that push, stick, remember, or show another motion."""

from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
from jaxtyping import Array, Float

from exoid.physics.leg import angular_acceleration
from exoid.physics.moment import Moment, SegmentConstants
from exoid.physics.state import LegState
from exoid.physics.term import Reading, Term, holds, reading

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


@jax.jit  # traced once, for all stages of a step
def slopes(
    place: SegmentConstants,
    terms: Terms,
    at: Motion,
    time: Any,
    push: Any,
    free: Any,
    sense: Any = None,
) -> Motion:
    """The time derivatives of leg and terms; `free` is 0 while the leg sticks, and dry friction is
    against the way of `sense`.
    """
    now = moment(place, at.leg, time, push)
    faster = now.angular_acceleration
    if terms:
        faster = faster + missing(terms, now, at.memory)
    if sense is not None:
        faster = faster - sense * friction(terms, now) / place.inertia
    moving = LegState(at.leg.angular_velocity, faster)
    if sticky(terms):
        moving = jax.tree.map(lambda slope: free * slope, moving)
    changes = tuple(term.memory_rate(now, own) for term, own in zip(terms, at.memory, strict=True))
    return Motion(moving, changes)


def gaps(
    place: SegmentConstants, terms: Terms, motion: Motion, time: Any, push: Any
) -> list[tuple[Float[Array, ""], Float[Array, ""]]]:
    """How far every contact of every term is, and how fast that grows."""
    now = moment(place, motion.leg, time, push)
    each = zip(terms, motion.memory, strict=True)
    return [gap for term, memory in each for gap in term.gaps(now, memory)]


def sticky(terms: Terms) -> bool:
    """Does any of them hold a leg at rest?"""
    return any(holds(type(term)) for term in terms)


def sticks(place: SegmentConstants, terms: Terms, motion: Motion, time: Any, push: Any):
    """Does the leg stand still, with more friction than what pulls at it?"""
    level = rubbed(place, terms, motion, time, push)
    held = (jnp.abs(pulled(place, terms, motion, time, push)) <= level) & (level > 0)
    return (motion.leg.angular_velocity == 0) & held


def pulled(
    place: SegmentConstants, terms: Terms, motion: Motion, time: Any, push: Any
) -> Float[Array, "*batch"]:
    """What all but dry friction makes of the acceleration [rad/s^2]."""
    now = moment(place, motion.leg, time, push)
    return now.angular_acceleration + missing(terms, now, motion.memory)


def rubbed(
    place: SegmentConstants, terms: Terms, motion: Motion, time: Any, push: Any
) -> Float[Array, "*batch"]:
    """What dry friction takes of a velocity [rad/s^2]."""
    return friction(terms, moment(place, motion.leg, time, push)) / place.inertia


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
