"""The compiled program: the whole library at once, each term along the motion that was measured.

A free-running simulation is linear in what is wrong with it only as long as little is. Here the
simulation is pinned to the measured motion at every sample (multiple shooting, a node at each), and
what it does otherwise is carried along linearly (`carry`), so that the misfit is exact to second
order in the noise wherever the model is right, however far the baseline is from it, and a term
costs its torque along the motion and no simulation.
"""

from functools import partial
from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
from jaxtyping import Array, Float, Int

from exoid.fitting.data.conditioning_chain import Chain
from exoid.fitting.data.observation import Observation
from exoid.fitting.misfit.stage import Stage
from exoid.fitting.model.coordinates import Coordinates, Unknowns, of_segments
from exoid.mismatch.screen.deviation import products
from exoid.mismatch.screen.effect import columns, named, remembered, shown
from exoid.mismatch.screen.hypothesis import Effect
from exoid.mismatch.screen.measured_motion import MeasuredMotion, SegmentMotion, segment_motions
from exoid.physics.library import MOST_PARAMETERS
from exoid.physics.motion.step import Drive
from exoid.physics.term import Term

AT_ONCE = 16  # candidates and segments


class Pinned(eqx.Module):
    """(J, r)'(J, r) of every candidate and segment: baseline unknowns, zeros, terms, residual."""

    gram: Float[Any, "candidate segment column column"]
    motion: MeasuredMotion  # along which
    first: Effect  # of the first candidates: what their first term does, and its derivatives


class LinearTerms(eqx.Module):
    """First terms of candidates as they were found: linear in their parameters."""

    effect: Effect  # (linear, 1 + parameter, segment, time): with none at 0
    which: Int[Any, " candidate"]  # of them a candidate has
    change: Float[Any, "candidate parameter"]  # of the parameters since


class Requests(eqx.Module):
    """What is asked of one term: its parameters' values, and whose it is."""

    values: Float[Any, "request parameter"]
    candidate: Int[Any, " request"]  # its row in the batch
    slot: Int[Any, " request"]  # which of the candidate's terms it is


def evaluate(
    requests: tuple[Requests, ...],
    linear: LinearTerms,
    points: Coordinates,
    zero: Float[Array, "candidate 2"],  # rad/s of the gyro, rad of the encoder
    motions: MeasuredMotion,
    measured: MeasuredMotion,
    observation: Observation,
    known: Unknowns,
    steps: Int[Array, ""],
    used: Int[Array, ""],
    tether: Float[Array, ""],  # rad/s
    static: tuple[tuple[type[Term], ...], Chain],
) -> Pinned:
    """Every candidate's misfit and its derivatives.

    `motions` are where the candidates were last, `measured` is what the sensors show. The requests
    are those of each term in `static`; a candidate's first term may be `linear`. Only the first
    `used` candidates are worked out, and requests of others are none. A `tether` makes a candidate
    forget what it once did otherwise: its misfit is then that of its torques, nearly.
    """
    terms, chain = static
    asked = list(zip(terms, requests, strict=True))
    see = jax.vmap(partial(segment_motions, observation=observation))
    first = jax.tree.map(partial(moved, linear), linear.effect)
    angle = first.shown[:, 0, :, :, 0] + zero[:, 1, None, None]
    motions = read(asked, see(points, motions), angle, measured, observation)
    seen = see(points, motions)
    effects = nothing(observation, zero.shape[0], 2)
    effects = jax.tree.map(lambda all, new: all.at[:, 0].set(new), effects, first)
    for term, request in asked:
        effects = jax.lax.cond(
            jnp.any(request.candidate < used), partial(added, term, request, seen), same, effects
        )
    summed = jax.tree.map(lambda leaf: jnp.moveaxis(together(leaf), 2, 1), effects)
    own = (jax.vmap(of_segments, in_axes=(0, None))(points, observation.owner), motions)
    each = partial(products, stage=Stage(tether, steps), chain=chain)
    by_segment: Any = jax.vmap(each, in_axes=(0, 0, 0, 0, 0, 0, None))

    def one(candidate):
        own, summed, zero = candidate
        return by_segment(*own, observation, known, summed.push, summed.shown, zero)

    at_once = max(1, AT_ONCE // observation.time.shape[0])
    gram = first_of(used, one, (own, summed, zero), at_once)
    kept = linear.effect.shown.shape[0]
    return Pinned(gram, motions, jax.tree.map(lambda leaf: leaf[:kept, 0], effects))


def added(term: type[Term], request: Requests, seen: SegmentMotion, effects: Effect) -> Effect:
    """With what a term does in the candidates that ask."""
    found = jax.vmap(partial(columns, term))(request.values, of_candidates(seen, request))
    at = (request.candidate, request.slot)
    return jax.tree.map(lambda all, new: all.at[at].add(new), effects, found)


def same(effects: Effect) -> Effect:
    return effects


def first_of(count: Int[Array, ""], task, given, at_once: int):
    """`task` of the first `count` rows of what is given, so many at once; zero for the others."""
    size = jax.tree.leaves(given)[0].shape[0]
    at_once, many = min(at_once, size), jax.vmap(task)

    def part(number, found):
        first = jnp.minimum(number * at_once, size - at_once)
        rows = jax.tree.map(lambda leaf: jax.lax.dynamic_slice_in_dim(leaf, first, at_once), given)
        return jax.lax.dynamic_update_slice_in_dim(found, many(rows), first, 0)

    room = jax.eval_shape(many, given)
    return jax.lax.fori_loop(0, -(-count // at_once), part, jnp.zeros(room.shape, room.dtype))


def moved(linear: LinearTerms, leaf: Array) -> Array:
    """What every candidate's linear term does now."""
    own = leaf[linear.which]
    change = jnp.einsum("cp,cp...->c...", linear.change, own[:, 1:])
    return own.at[:, 0].add(change)


def of_candidates(seen: SegmentMotion, request: Requests) -> SegmentMotion:
    """The motions of the candidates that ask."""
    return jax.tree.map(lambda leaf: leaf[request.candidate], seen)


def read(
    asked, seen: SegmentMotion, angle: Array, measured: MeasuredMotion, observation: Observation
) -> MeasuredMotion:
    """The leg's motion behind what the sensors show, if the candidates' terms are right.

    `angle` is what the linear terms show.
    """
    for term, request in asked:
        if term.shown is Term.shown:
            continue

        def error(value, seen, term=term):
            one = named(term, value)
            return jax.vmap(lambda at: shown(one, at, remembered(one, at)).angle)(seen)

        found = jax.vmap(error)(request.values, of_candidates(seen, request))
        angle = angle.at[request.candidate].add(found)
    slope = jax.vmap(jax.vmap(rate), in_axes=(0, None))
    velocity = slope(angle, observation.time)
    errors = MeasuredMotion(angle, velocity, slope(velocity, observation.time))
    return jax.tree.map(jnp.subtract, measured, errors)


def rate(value, time):
    """The time derivative, by the parabola through three samples."""
    steps, rises = jnp.diff(time), jnp.diff(value)
    slopes = rises / steps
    inner = (slopes[:-1] * steps[1:] + slopes[1:] * steps[:-1]) / (steps[1:] + steps[:-1])
    return jnp.concatenate([slopes[:1], inner, slopes[-1:]])


def nothing(observation: Observation, candidates: int, slots: int) -> Effect:
    """Room for what all terms do: (candidate, slot, 1 + parameter, segment, time)."""
    segments, size = observation.time.shape
    room = (candidates, slots, 1 + MOST_PARAMETERS, segments)
    push = jnp.zeros((*room, size - 1))
    return Effect(Drive(push, push, push), jnp.zeros((*room, size, 2)))


def together(leaf: Array) -> Array:
    """(candidate, slot, 1 + parameter, ...) to (candidate, column, ...): derivatives, then sum."""
    parts = [leaf[:, slot, 1:] for slot in range(leaf.shape[1])]
    return jnp.concatenate([*parts, leaf[:, :, :1].sum(axis=1)], axis=1)
