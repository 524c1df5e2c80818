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
from exoid.fitting.misfit.condense import products_and
from exoid.fitting.misfit.rollout import numbers_of, rollout_of
from exoid.fitting.misfit.stage import Stage
from exoid.fitting.model.coordinates import (
    Coordinates,
    Unknowns,
    in_a_row,
    of_segments,
)
from exoid.mismatch.screen.effect import named
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


def segment(terms, chain, stage, values, zero, unknowns, observation, known):
    """One segment's products and what its sensors would show."""
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
    room = jnp.zeros((observation.time.size, 2))
    given = (rollout, change * moving, observation, stage, chain)
    total, shown = products_and(store, room, *given)
    zero, scale, bias = rollout.sensors
    return total, jnp.stack([shown[:, 0] + zero, (1 + scale) * shown[:, 1] + bias], axis=1)


def store(index, shown: LegState, table):
    """One sample more of what is shown."""
    return table.at[index].set(jnp.stack([shown.angle, shown.angular_velocity]))
