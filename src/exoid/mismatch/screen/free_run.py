"""A candidate running free: its own simulation of every segment, with exact derivatives."""

from functools import partial
from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
from jax.flatten_util import ravel_pytree
from jaxtyping import Array, Float, Int

from exoid.fitting.data.conditioning_chain import Chain
from exoid.fitting.data.observation import Observation
from exoid.fitting.data.stage import Stage
from exoid.fitting.misfit.condense import outer, products_and
from exoid.fitting.misfit.rollout import numbers_of, rollout_of, sweep
from exoid.fitting.model.coordinates import (
    Coordinates,
    Unknowns,
    in_a_row,
    of_segments,
)
from exoid.mismatch.screen.effect import named
from exoid.mismatch.screen.hypothesis import Effect
from exoid.physics.state import LegState
from exoid.physics.term import Term


class Released(eqx.Module):
    """(J, r)'(J, r) of every segment, and what the sensors would show."""

    gram: Float[Any, "segment column column"]
    shown: Float[Any, "segment time channel"]  # rad, rad/s


def release(
    values: tuple[Array, ...],
    point: Coordinates,
    zero: Float[Array, "2"],
    observation: Observation,
    known: Unknowns,
    steps: Int[Array, ""],
    static: tuple[tuple[type[Term], ...], Chain],
) -> Released:
    """A candidate's misfit and derivatives, and the motion that its sensors would show.

    Columns as in `pinned`: baseline unknowns, zeros of gyro and encoder, terms' parameters,
    residual.
    """
    terms, chain = static
    stage = Stage(jnp.zeros(()), steps, compact=True)
    each: Any = partial(segment, terms, chain, stage, values, zero)
    by_segment = jax.vmap(each)
    gram, shown = by_segment(of_segments(point, observation.owner), observation, known)
    return Released(gram, shown)


def respond(
    values: tuple[Array, ...],
    point: Coordinates,
    zero: Float[Array, "2"],
    observation: Observation,
    known: Unknowns,
    steps: Int[Array, ""],
    beside: Effect,  # (column, segment, time)
    static: tuple[tuple[type[Term], ...], Chain],
) -> Float[Array, "segment column column"]:
    """(J, n, r)'(J, n, r) of a candidate, n being what may act or be shown beside its terms."""
    terms, chain = static
    stage = Stage(jnp.zeros(()), steps, compact=True)
    each: Any = partial(answer, terms, chain, stage, values, zero)
    by_segment = jax.vmap(each, in_axes=(0, 0, 0, 1))
    return by_segment(of_segments(point, observation.owner), observation, known, beside)


def answer(terms, chain, stage, values, zero, unknowns, observation, known, beside):
    """One segment's products with those of what is beside."""
    rollout, change = having(terms, stage, values, zero, unknowns, observation, known)
    count, first = beside.shown.shape[0], change.shape[0]
    pushes = jax.tree.map(lambda leaf: leaf / rollout.share, beside.push)

    def gather(index, rows, shown, total):
        weight = jnp.stack([observation.angle_weight[index], observation.velocity_weight[index]])
        return total + outer(rows.at[first:-1].add(weight * beside.shown[:, index]))

    empty = jnp.zeros((first + count + 1,) * 2)
    total = sweep(rollout, observation, pushes, stage, chain, gather, empty)
    change = jax.scipy.linalg.block_diag(change, jnp.eye(count + 1))
    return change.T @ total @ change


def segment(terms, chain, stage, values, zero, unknowns, observation, known):
    """One segment's products and what its sensors would show."""
    rollout, change = having(terms, stage, values, zero, unknowns, observation, known)
    room = jnp.zeros((observation.time.size, 2))
    total, shown = products_and(store, room, rollout, change, observation, stage, chain)
    zero, scale, bias = rollout.sensors
    return total, jnp.stack([shown[:, 0] + zero, (1 + scale) * shown[:, 1] + bias], axis=1)


def having(terms, stage, values, zero, unknowns, observation, known):
    """The rollout of one segment with these terms, and its numbers by all unknowns."""
    base, back = in_a_row(unknowns)
    cuts = np.cumsum([base.size, zero.size, *(value.size for value in values)])[:-1]

    def numbers(row):
        own, (bias, offset), *each = jnp.split(row, cuts)
        eq, start, sensors = numbers_of(back(own), observation, stage)
        having = tuple(named(term, value) for term, value in zip(terms, each, strict=True))
        eq = eqx.tree_at(lambda eq: eq.terms, eq, having)
        return eq, start, sensors + jnp.stack([offset, jnp.zeros(()), bias])

    row = jnp.concatenate([base, zero, *values])
    rollout, change = rollout_of(numbers, row)
    moving = jnp.concatenate([1 - ravel_pytree(known)[0], jnp.ones(row.size - base.size)])
    return rollout, change * moving


def store(index, shown: LegState, table):
    """One sample more of what is shown."""
    return table.at[index].set(jnp.stack([shown.angle, shown.angular_velocity]))
