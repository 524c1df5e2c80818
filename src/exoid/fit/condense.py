"""The misfit of a segment and its derivatives, condensed to as many numbers as it has unknowns.

With J = QR the residual r may be replaced by (R dz + Q'r, |r - QQ'r|): the same misfit, gradient
and Gauss-Newton matrix in 8 numbers instead of two per sample. A joint fit of many segments
becomes a small dense problem, and R and Q'r are what the standard errors need.
"""

from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
from jaxtyping import Array, Float

from exoid.fit.chain import Chain
from exoid.fit.coordinates import (
    Coordinates,
    Mounting,
    Own,
    Seat,
    Shared,
    by_segment,
    in_a_row,
)
from exoid.fit.observation import Observation
from exoid.fit.residual import NOTHING, Stage, advance, equation, residual, sensor_map
from exoid.physics.state import LegState
from exoid.physics.step import Drive, march

ROUNDING = 1e-13  # relative, keeps the Cholesky factor real where two columns are nearly parallel


class Condensed(eqx.Module):
    """R, Q'r and the rest of one segment's residual, in units of noise and of `TYPICAL`."""

    factor: Float[Any, "*batch unknown unknown"]
    projection: Float[Any, "*batch unknown"]
    remainder: Float[Any, "*batch"]


def condense(
    shared: Shared,
    mounting: Mounting,
    own: Own,
    observation: Observation,
    known: Float[Array, " unknown"],
    stage: Stage,
    chain: Chain,
) -> Condensed:
    """Simulate one segment with its sensitivities. `known` is 1 for unknowns that play no part.

    The sum over samples of (dr/dz, r)'(dr/dz, r) is gathered on the way: nothing is stored.
    """
    # While tied only the angle counts: where encoder and gyro disagree, the spring would turn
    # their difference into a torque.
    counted = jnp.where(stage.tether > 0, 0.0, observation.velocity_weight)
    observation = eqx.tree_at(lambda seen: seen.velocity_weight, observation, counted)

    def gather(index, rows, total):
        return total + outer(rows)

    nothing = jnp.zeros((known.size + 1, known.size + 1))
    unknowns = (shared, mounting, own)
    none = jax.tree.map(lambda leaf: jnp.zeros((0, leaf.size)), observation.cycle)
    total = sweep(unknowns, observation, known, none, stage, chain, gather, nothing)
    return factorise(total, known)


class Sensed(eqx.Module):
    """The residual of every sample, and its derivatives, in units of noise and of `TYPICAL`."""

    residual: Float[Any, "*segment time channel"]
    columns: Float[Any, "*segment unknown time channel"]
    responses: Float[Any, "*segment push time channel"]  # to missing torques


def sense(
    shared: Shared,
    mounting: Mounting,
    own: Own,
    observation: Observation,
    known: Float[Array, " unknown"],
    pushes: Drive,
    stage: Stage,
    chain: Chain,
) -> Sensed:
    """`condense`, sample by sample; also along torques [J rad/s^2], (push, step)."""

    def store(index, rows, table):
        return table.at[:, index].set(rows)

    count = pushes.begin.shape[0]
    empty = jnp.zeros((known.size + count + 1, observation.time.size, 2))
    unknowns = (shared, mounting, own)
    table = sweep(unknowns, observation, known, pushes, stage, chain, store, empty)
    return Sensed(table[-1], table[: known.size], table[known.size : -1])


def sweep(unknowns, observation, known, pushes, stage, chain, fold, folded):
    """Simulate with sensitivities; `fold` gathers the rows (dr/dz, dr/dpush, r) of every sample."""
    row, back = in_a_row(unknowns)

    def setup(row):
        shared, mounting, own = back(row)
        state = LegState(own.angle, own.angular_velocity)
        eq = equation(shared, mounting, own, observation, stage)
        return (eq, sensor_map(mounting, observation)), state, chain.begin(state)

    count = pushes.begin.shape[0]
    directions = jnp.concatenate([jnp.diag(1 - known), jnp.zeros((count, known.size))])
    ((eq, sensors), state, memory), ((by_eq, by_sensors), by_state, by_memory) = along(
        setup, (row,), (directions,)
    )

    def forward(index, carry):
        def step(eq, state, missing):
            return advance(eq, state, index, observation, stage, missing)

        def pushed(leaf):
            return jnp.concatenate([jnp.zeros(known.size), leaf[:, index]])

        missing = jax.tree.map(jnp.asarray, NOTHING)
        return along(step, (eq, carry[0], missing), (by_eq, carry[1], jax.tree.map(pushed, pushes)))

    def gather(index, carry, gathered):
        (memory, by_memory), folded = gathered

        def show(state, memory, sensors):
            memory, shown = chain.push(memory, state)
            return memory, residual(shown, sensors, index, observation)

        (memory, value), (by_memory, columns) = along(
            show, (carry[0], memory, sensors), (carry[1], by_memory, by_sensors)
        )
        rows = jnp.concatenate([columns, value[None]])
        return (memory, by_memory), fold(index, rows, folded)

    begin = ((memory, by_memory), folded)
    return march(forward, gather, (state, by_state), begin, stage.steps)[1]


def along(function, primals, tangents):
    """The value of `function` and its derivatives along several directions at once."""

    def one(*direction):
        return jax.jvp(function, primals, direction)

    return jax.vmap(one, out_axes=(None, 0))(*tangents)


def outer(rows: Float[Array, "column 2"]) -> Float[Array, "column column"]:
    """The sum over angle and velocity of the outer products, without a matrix multiply call."""
    return jnp.sum(rows[:, None, :] * rows[None, :, :], axis=-1)


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
    condensed: Condensed, at: Coordinates, to: Coordinates, seat: Seat
) -> Float[Array, " residual"]:
    """The condensed residual at `to`, by its linear model around `at` (all scaled)."""
    change = by_segment(jax.tree.map(jnp.subtract, to, at), seat)
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
