"""The compiled programs of the screen: a term along the motion that was measured, and the misfit.

A free-running simulation is linear in what is wrong with it only as long as little is. Here the
simulation is pinned to the measured motion at every sample (multiple shooting, a node at each), and
what it does otherwise is carried along linearly (`carry`), so that the misfit is exact to second
order in the noise wherever the model is right, however far the baseline is from it, and a term
costs its torque along the motion and no simulation. Every term has small programs of its own, that
compile side by side and serve whatever set it is in.
"""

from functools import partial
from typing import Any

import jax
from jaxtyping import Array, Float, Int

from exoid.fitting.data.conditioning_chain import Chain
from exoid.fitting.data.observation import Observation
from exoid.fitting.data.stage import Stage
from exoid.fitting.misfit.equation import equation
from exoid.fitting.model.coordinates import Coordinates, Unknowns, of_segments
from exoid.mismatch.screen.deviation import Deviations, deviations
from exoid.mismatch.screen.effect import columns, named, remembered, shown
from exoid.mismatch.screen.hypothesis import Effect
from exoid.mismatch.screen.measured_motion import (
    FREE,
    MeasuredMotion,
    SegmentMotion,
    segment_motion,
)
from exoid.physics.term import Term


def along(
    points: Coordinates, motions: MeasuredMotion, observation: Observation, _: None
) -> SegmentMotion:
    """What terms see of every candidate's motion: (candidate, segment, ...)."""

    def one(unknowns, measured, observation):
        return segment_motion(equation(unknowns, observation, FREE), measured, observation)

    def each(point: Coordinates, motion: MeasuredMotion) -> SegmentMotion:
        return jax.vmap(one)(of_segments(point, observation.owner), motion, observation)

    return jax.vmap(each)(points, motions)


def show(
    values: Float[Array, "request parameter"], motions: SegmentMotion, term: type[Term]
) -> Float[Array, "request segment time"]:
    """The encoder's error that a term makes [rad]."""

    def one(value: Float[Array, " parameter"], motions: SegmentMotion):
        own = named(term, value)

        def error(motion: SegmentMotion):
            return shown(own, motion, remembered(own, motion)).angle

        return jax.vmap(error)(motions)

    return jax.vmap(one)(values, motions)


def act(
    values: Float[Array, "request parameter"], motions: SegmentMotion, term: type[Term]
) -> Effect:
    """What a term does, and the derivatives by its parameters: (request, 1 + parameter, segment,
    time).
    """
    return jax.vmap(partial(columns, term))(values, motions)


def deviate(
    points: Coordinates,
    motions: MeasuredMotion,
    effects: Effect,  # (candidate, parameter, segment, time), all together behind the parameters
    zero: Float[Array, "candidate 2"],  # rad/s of the gyro, rad of the encoder
    observation: Observation,
    known: Unknowns,
    steps: Int[Array, ""],
    tether: Float[Array, ""],  # rad/s
    chain: Chain,
) -> Deviations:
    """(J, r) of every candidate and segment: baseline unknowns, zeros, terms, residual.

    A `tether` makes a candidate forget what it once did otherwise: its misfit is then that of its
    torques, nearly.
    """
    each = partial(deviations, stage=Stage(tether, steps), chain=chain)
    by_segment: Any = jax.vmap(each, in_axes=(0, 0, 0, 0, 1, 1, None))

    def one(point, motion, effect, zero):
        own = of_segments(point, observation.owner)
        return by_segment(own, motion, observation, known, effect.push, effect.shown, zero)

    return jax.vmap(one)(points, motions, effects, zero)
