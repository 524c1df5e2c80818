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
from exoid.fitting.misfit.stage import Stage
from exoid.fitting.model.coordinates import Coordinates, Unknowns, of_segments
from exoid.mismatch.screen.deviation import products
from exoid.mismatch.screen.effect import columns, named, remembered, shown
from exoid.mismatch.screen.hypothesis import Effect
from exoid.mismatch.screen.measured_motion import (
    MeasuredMotion,
    Requests,
    SegmentMotion,
    segment_motions,
)
from exoid.physics.term import Term


def show(
    requests: Requests, observation: Observation, term: type[Term]
) -> Float[Array, "request segment time"]:
    """The encoder's error that a term makes [rad]."""

    def one(request: Requests):
        own = named(term, request.values)

        def error(motion: SegmentMotion):
            return shown(own, motion, remembered(own, motion)).angle

        return jax.vmap(error)(along(request, observation))

    return jax.vmap(one)(requests)


def act(requests: Requests, observation: Observation, term: type[Term]) -> Effect:
    """What a term does, and the derivatives by its parameters: (request, 1 + parameter, segment,
    time).
    """

    def one(request: Requests):
        return columns(term, request.values, along(request, observation))

    return jax.vmap(one)(requests)


def along(request: Requests, observation: Observation) -> SegmentMotion:
    """The motion of every segment."""
    return segment_motions(request.points, request.motions, observation)


def fold(
    points: Coordinates,
    motions: MeasuredMotion,
    effects: Effect,  # (candidate, parameter, segment, time), all together behind the parameters
    zero: Float[Array, "candidate 2"],  # rad/s of the gyro, rad of the encoder
    observation: Observation,
    known: Unknowns,
    steps: Int[Array, ""],
    tether: Float[Array, ""],  # rad/s
    chain: Chain,
) -> Float[Array, "candidate segment column column"]:
    """(J, r)'(J, r) of every candidate and segment: baseline unknowns, zeros, terms, residual.

    A `tether` makes a candidate forget what it once did otherwise: its misfit is then that of its
    torques, nearly.
    """
    each = partial(products, stage=Stage(tether, steps), chain=chain)
    by_segment: Any = jax.vmap(each, in_axes=(0, 0, 0, 0, 1, 1, None))

    def one(point, motion, effect, zero):
        own = of_segments(point, observation.owner)
        return by_segment(own, motion, observation, known, effect.push, effect.shown, zero)

    return jax.vmap(one)(points, motions, effects, zero)
