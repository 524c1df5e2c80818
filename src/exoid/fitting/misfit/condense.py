"""The misfit of a segment and its derivatives, condensed to as many numbers as it has unknowns.

With J = QR the residual r may be replaced by (R dz + Q'r, |r - QQ'r|): the same misfit, gradient
and Gauss-Newton matrix in 8 numbers instead of two per sample. A joint fit of many segments
becomes a small dense problem, and R and Q'r are what the standard errors need.
"""

from collections.abc import Callable
from functools import partial
from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
from jax.flatten_util import ravel_pytree
from jaxtyping import Array, Float, Int, PyTree

from exoid.fitting.data.conditioning_chain import Chain
from exoid.fitting.data.observation import Observation
from exoid.fitting.data.stage import Stage
from exoid.fitting.misfit.condensed import Condensed, Sensed
from exoid.fitting.misfit.rollout import Rollout, of_unknowns, sweep
from exoid.fitting.model.coordinates import Coordinates, Unknowns, by_segment
from exoid.physics.motion.step import Drive
from exoid.physics.state import LegState

ROUNDING = 1e-13  # relative, keeps the Cholesky factor real where two columns are nearly parallel


@partial(jax.jit, static_argnames="chain")  # traced once, though a solver asks for it twice
def condense(
    unknowns: Unknowns, observation: Observation, known: Unknowns, stage: Stage, chain: Chain
) -> Condensed:
    """Simulate one segment with its sensitivities. `known` is 1 for unknowns that play no part.

    The sum over samples of (dr/dz, r)'(dr/dz, r) is gathered on the way: nothing is stored.
    """
    # While tied only the angle counts: where encoder and gyro disagree, the spring would turn
    # their difference into a torque.
    counted = jnp.where(stage.tether > 0, 0.0, observation.velocity_weight)
    observation = eqx.tree_at(lambda seen: seen.velocity_weight, observation, counted)
    rollout, change = of_unknowns(unknowns, observation, known, stage)
    total = products(rollout, change, observation, stage, chain)
    return factorise(total, ravel_pytree(known)[0])


def products(
    rollout: Rollout,
    change: Float[Array, "number column"],
    observation: Observation,
    stage: Stage,
    chain: Chain,
) -> Float[Array, "row row"]:
    """(dr/dz, r)'(dr/dz, r) of a segment, where `change` is its rollout's numbers by z."""

    def keep(index, shown, kept):
        return kept

    return products_and(keep, (), rollout, change, observation, stage, chain)[0]


def products_and(
    keep: Callable[[Int[Array, ""], LegState, PyTree], PyTree],
    kept: PyTree,
    rollout: Rollout,
    change: Float[Array, "number column"],
    observation: Observation,
    stage: Stage,
    chain: Chain,
) -> tuple[Float[Array, "row row"], PyTree]:
    """The same, and what `keep(index, shown, kept)` gathers of what a leg shows to its sensors."""

    def gather(index, rows, shown, folded):
        total, kept = folded
        return total + outer(rows), keep(index, shown, kept)

    none = jax.tree.map(lambda leaf: jnp.zeros((0, leaf.size)), observation.cycle)
    size = change.shape[0] + 1
    empty = jnp.zeros((size, size)), kept
    total, kept = sweep(rollout, observation, none, stage, chain, gather, empty)
    change = jax.scipy.linalg.block_diag(change, jnp.ones((1, 1)))
    return change.T @ total @ change, kept


def sense(
    unknowns: Unknowns,
    observation: Observation,
    known: Unknowns,
    pushes: Drive,
    stage: Stage,
    chain: Chain,
) -> Sensed:
    """`condense`, sample by sample; also along torques [J rad/s^2], (push, step)."""
    rollout, change = of_unknowns(unknowns, observation, known, stage)

    def store(index, rows, shown, table):
        return table.at[index].set(rows)

    size = change.shape[0]
    # What is stored together lies together: a sample's rows.
    empty = jnp.zeros((observation.time.size, size + pushes.begin.shape[0] + 1, 2))
    table = sweep(rollout, observation, pushes, stage, chain, store, empty).swapaxes(0, 1)
    columns = jnp.einsum("bu,btc->utc", change, table[:size])
    return Sensed(table[-1], columns, table[size:-1])


def outer(rows: Float[Array, "column 2"]) -> Float[Array, "column column"]:
    """The sum over angle and velocity of the outer products, written out: a matrix multiply or a
    sum over an axis would be a call out of the compiled loop.
    """
    angle, velocity = rows.T
    return angle[:, None] * angle + velocity[:, None] * velocity


def factorise(total: Float[Array, "column column"], known: Float[Array, " unknown"]) -> Condensed:
    """R, Q'r and the rest from (J, r)'(J, r)."""
    normal, gradient, square = total[:-1, :-1], total[:-1, -1], total[-1, -1]
    # A known unknown, or one that moves nothing (the gyro's scale where there is no gyro), stands
    # apart from the rest: 1 on the diagonal to factorise, 0 afterwards.
    known = jnp.where(jnp.diag(normal) > 0, known, 1.0)
    normal = normal + jnp.diag(ROUNDING * jnp.diag(normal) + known)
    lower = jnp.linalg.cholesky(normal)
    projection = jax.scipy.linalg.solve_triangular(lower, gradient, lower=True)
    remainder = jnp.sqrt(jnp.maximum(square - projection @ projection, 0.0))
    return Condensed(lower.T * (1 - known), projection, remainder)


def linear_model(
    condensed: Condensed, at: Coordinates, to: Coordinates, owner: Int[Any, " segment"]
) -> Float[Array, " residual"]:
    """The condensed residual at `to`, by its linear model around `at` (all scaled)."""
    change = by_segment(jax.tree.map(jnp.subtract, to, at), owner)
    predicted = condensed.projection + jnp.einsum("kij,kj->ki", condensed.factor, change)
    return jnp.concatenate([predicted.ravel(), condensed.remainder])


def weighed(condensed: Condensed, scale: Float[Array, " segment"]) -> Condensed:
    """Of every segment, where its residual counts 1 / `scale`."""

    def divided(leaf):
        return leaf / scale.reshape(-1, *[1] * (leaf.ndim - 1))

    return jax.tree.map(divided, condensed)


def misfit(condensed: Condensed) -> Float[Array, ""]:
    """The sum of squares of the residual of all segments."""
    return jnp.sum(condensed.projection**2) + jnp.sum(condensed.remainder**2)
