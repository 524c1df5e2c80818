"""The misfit of a segment and its derivatives, condensed to as many numbers as it has unknowns.

With J = QR the residual r may be replaced by (R dz + Q'r, |r - QQ'r|): the same misfit, gradient
and Gauss-Newton matrix in 8 numbers instead of two per sample. A joint fit of many segments
becomes a small dense problem, and R and Q'r are what the standard errors need.
"""

from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
from jax.flatten_util import ravel_pytree
from jaxtyping import Array, Float, Int

from exoid.fitting.data.conditioning_chain import Chain
from exoid.fitting.data.observation import Observation
from exoid.fitting.misfit.condensed import Condensed, Rollout, Sensed, of_unknowns
from exoid.fitting.misfit.residual import (
    NOTHING,
    Shown,
    advance,
    begin,
    glimpse,
    late,
    residual,
    shows,
    through,
)
from exoid.fitting.misfit.stage import Stage
from exoid.fitting.model.coordinates import (
    Coordinates,
    Unknowns,
    by_segment,
)
from exoid.physics.motion.step import Drive, march
from exoid.physics.state import LegState

ROUNDING = 1e-13  # relative, keeps the Cholesky factor real where two columns are nearly parallel
MOVING = (
    *("gravity", "stiffness", "damping", "thigh_angle", "cycle", "torque"),
    *("angle", "angular_velocity"),
)  # what a segment's motion depends on: Eq. 9 per inertia, and where it begins
SHOWING = ("zero", "scale", "bias")  # what its sensors make of it


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

    def gather(index, rows, total):
        return total + outer(rows)

    none = jax.tree.map(lambda leaf: jnp.zeros((0, leaf.size)), observation.cycle)
    size = change.shape[0] + 1
    total = sweep(rollout, observation, none, stage, chain, gather, jnp.zeros((size, size)))
    change = jax.scipy.linalg.block_diag(change, jnp.ones((1, 1)))
    return factorise(change.T @ total @ change, ravel_pytree(known)[0])


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

    def store(index, rows, table):
        return table.at[:, index].set(rows)

    size = change.shape[0]
    empty = jnp.zeros((size + pushes.begin.shape[0] + 1, observation.time.size, 2))
    table = sweep(rollout, observation, pushes, stage, chain, store, empty)
    columns = jnp.einsum("bu,btc->utc", change, table[:size])
    return Sensed(table[-1], columns, table[size:-1])


def sweep(rollout: Rollout, observation, pushes, stage, chain, fold, folded):
    """Simulate with sensitivities; `fold` gathers the rows (dr/db, dr/dpush, r) of every sample, b
    being the coefficients and the map of the sensors.
    """
    size, count = rollout.coefficients.size, pushes.begin.shape[0]
    directions = jnp.concatenate([jnp.eye(size), jnp.zeros((count, size))])
    terms = rollout.equation(rollout.coefficients)[0].terms

    def first(coefficients):
        eq, start = rollout.equation(coefficients)
        motion = begin(eq, start, observation, stage)
        shown = glimpse(eq, motion, jnp.asarray(0), observation, stage)
        return motion, chain.begin(shown.motion)

    (motion, memory), (by_motion, by_memory) = along(first, (rollout.coefficients,), (directions,))

    def forward(index, carry):
        def step(coefficients, motion, missing):
            eq, _ = rollout.equation(coefficients)
            return advance(eq, motion, index, observation, stage, missing)

        def pushed(leaf):
            return jnp.concatenate([jnp.zeros(size), leaf[:, index]])

        missing = jax.tree.map(jnp.asarray, NOTHING)
        tangents = (directions, carry[1], jax.tree.map(pushed, pushes))
        return along(step, (rollout.coefficients, carry[0], missing), tangents)

    def look(index, carry, memory, by_memory):
        def seen(coefficients, motion, memory):
            eq, _ = rollout.equation(coefficients)
            return through(chain, memory, glimpse(eq, motion, index, observation, stage))

        primals = (rollout.coefficients, carry[0], memory)
        return along(seen, primals, (directions, carry[1], by_memory))

    def rows(index, shown, by_shown):
        def misfit(shown, sensors):
            return residual(shown, sensors, index, observation)

        value, moved = along(lambda shown: misfit(shown, rollout.sensors), (shown,), (by_shown,))
        eye = jnp.eye(rollout.sensors.size)
        _, mapped = along(lambda sensors: misfit(shown, sensors), (rollout.sensors,), (eye,))
        return jnp.concatenate([moved[:size], mapped, moved[size:], value[None]])

    def gather(index, carry, gathered):
        memories, folded = gathered
        (memory, shown), (by_memory, by_shown) = look(index, carry, *memories)
        return (memory, by_memory), fold(index, rows(index, shown.motion, by_shown.motion), folded)

    def keep(index, carry, gathered):
        memories, table = gathered
        (memory, shown), (by_memory, by_shown) = look(index, carry, *memories)
        kept = jax.tree.map(lambda all, one: all.at[..., index].set(one), table, (shown, by_shown))
        return (memory, by_memory), kept

    carry, memories = (motion, by_motion), (memory, by_memory)
    if not shows(terms):
        return march(forward, gather, carry, (memories, folded), stage.steps)[1]
    # Where a gyro may be late, a sample hangs on later ones: all are simulated before one counts.
    one = jnp.zeros(observation.time.size)
    each = jnp.zeros((size + count, observation.time.size))
    room = Shown(LegState(one, one), one, one), Shown(LegState(each, each), each, each)
    table, by_table = march(forward, keep, carry, (memories, room), stage.steps)[1]
    shown, by_shown = along(lambda seen: late(seen, observation, stage), (table,), (by_table,))

    def count_in(index, _, folded):
        now = jax.tree.map(lambda leaf: leaf[..., index], (shown, by_shown))
        return fold(index, rows(index, *now), folded)

    return march(lambda index, nothing: nothing, count_in, (), folded, stage.steps)


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
    condensed: Condensed, at: Coordinates, to: Coordinates, seat: Int[Any, " segment"]
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
