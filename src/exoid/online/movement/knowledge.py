"""All that an estimator remembers between two samples."""

from typing import Any

import equinox as eqx
from jaxtyping import Bool, Float, Int

from exoid.online.filter.gaussian import Gaussian
from exoid.online.filter.whiteness import Whiteness

NEVER = 1_000_000  # turns that no movement has


class Recent(eqx.Module):
    """The last samples, as rows of `Sample`; sample number k stands in row k modulo the rows."""

    rows: Float[Any, "row 6"]
    heard: Int[Any, ""]  # samples that were taken in
    absorbed: Int[Any, ""]  # of them those that the filters have seen, or never will


class Stream(eqx.Module):
    """How well the samples arrive."""

    faults: Float[Any, ""]  # lost, doubled, missing; those of a second ago count a third
    frozen: Int[Any, ""]  # samples that showed the same rate to the last bit


class Kept(eqx.Module):
    """Both filters as they were at a time."""

    filters: Gaussian
    time: Float[Any, ""]  # s
    unwhite: Float[Any, ""]  # of the second's innovations until then, in standard deviations
    turns: Int[Any, ""]
    evidence: Float[Any, ""]  # that it is another leg


class Sensing(eqx.Module):
    """What a `Node` declares of its samples: one program serves sensors of any noise."""

    angle: Float[Any, ""]  # rad^2, variance
    angular_velocity: Float[Any, ""]  # (rad/s)^2
    wander: Float[Any, ""]  # s, see `SensorNoise`
    drift: Float[Any, ""]  # s in a second
    period: Float[Any, ""]  # s between samples


class Course(eqx.Module):
    """The movement that goes on, or the last one."""

    begun: Float[Any, ""]  # s, from when on it is taken as free
    reached: Float[Any, ""]  # s, up to when the filters followed
    ended: Float[Any, ""]  # s, up to when it counts
    torque: Float[Any, ""]  # N m, known, when they reached there
    opened: Bool[Any, ""]  # have they begun?
    whiteness: Whiteness
    likelihood: Float[Any, "2"]  # logarithm, by both filters
    astray: Int[Any, ""]  # samples in a row that cannot be the leg's
    direction: Float[Any, ""]  # -1, 0 or 1: the way it moves
    turns: Int[Any, ""]
    late: Int[Any, ""]  # 1 where it began as the leg turned, and what was before had strayed
    quick: Float[Any, "2"]  # rad, rad/s: where the leg was no longer slow in its first fall
    top: Float[Any, ""]  # rad, how near to its hold it last came: where it was let go, or turned
    scatter: Float[Any, "2 2"]  # that of the belief, and of this movement
    rested: Int[Any, ""]  # drops that the numbers rested on before it


class Verdict(eqx.Module):
    """What was found of the movements so far."""

    drops: Int[Any, ""]  # free movements of this leg that count
    rests: Int[Any, ""]  # the last of them, on which the numbers rest
    changed: Bool[Any, ""]  # is this another leg than before? Until a drop of it has ended
    unexplained: Bool[Any, ""]  # did the model fail in the last movement?
    suspected: Int[Any, ""]  # turns from which on a movement that ended astray was no hand's


class Knowledge(eqx.Module):
    """The leg as it is known, and what is needed to learn more of it.

    Of the two filters the first knows all drops, the second the present one alone.
    """

    filters: Gaussian
    newer: Kept  # a moment ago
    older: Kept  # and before that: no hand had touched the leg
    before: Gaussian  # the first filter before this movement
    prior: Gaussian  # what anatomy expects
    sensing: Sensing
    scatter: Float[Any, "2 2"]  # of angle and rate: squares over the declared ones, and how many
    phase: Int[Any, ""]
    hold: Float[Any, ""]  # rad, where it was last at rest
    recent: Recent
    stream: Stream
    course: Course
    verdict: Verdict
