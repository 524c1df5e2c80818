"""The misfit of a segment and its derivatives, condensed to as many numbers as it has unknowns.

With J = QR the residual r may be replaced by (R dz + Q'r, |r - QQ'r|): the same misfit, gradient
and Gauss-Newton matrix in 8 numbers instead of two per sample. A joint fit of many segments
becomes a small dense problem, and R and Q'r are what the standard errors need.
"""

from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
from jaxtyping import Array, Float, Int

from exoid.fitting.data.conditioning_chain import Chain
from exoid.fitting.data.observation import Observation
from exoid.fitting.misfit.condensed import Condensed, Sensed
from exoid.fitting.misfit.residual import NOTHING, Equation, advance, equation, residual, sensor_map
from exoid.fitting.misfit.stage import Stage
from exoid.fitting.model.coordinates import (
    Coordinates,
    Mounting,
    Own,
    Shared,
    by_segment,
    in_a_row,
)
from exoid.physics.leg import Ratios
from exoid.physics.motion.step import Drive, march
from exoid.physics.state import LegState

ROUNDING = 1e-13  # relative, keeps the Cholesky factor real where two columns are nearly parallel
MOVING = (
    *("gravity", "stiffness", "damping", "thigh_angle", "cycle", "torque"),
    *("angle", "angular_velocity"),
)  # what a segment's motion depends on: Eq. 9 per inertia, and where it begins
SHOWING = ("zero", "scale", "bias")  # what its sensors make of it


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

    unknowns = (shared, mounting, own)
    none = jax.tree.map(lambda leaf: jnp.zeros((0, leaf.size)), observation.cycle)
    size = len(MOVING) + len(SHOWING) + 1
    nothing = jnp.zeros((size, size))
    total, change = sweep(unknowns, observation, known, none, stage, chain, gather, nothing)
    change = jax.scipy.linalg.block_diag(change, jnp.ones((1, 1)))
    return factorise(change.T @ total @ change, known)


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
    size = len(MOVING) + len(SHOWING)
    empty = jnp.zeros((size + count + 1, observation.time.size, 2))
    unknowns = (shared, mounting, own)
    table, change = sweep(unknowns, observation, known, pushes, stage, chain, store, empty)
    columns = jnp.einsum("bu,btc->utc", change, table[:size])
    return Sensed(table[-1], columns, table[size:-1])


def sweep(unknowns, observation, known, pushes, stage, chain, fold, folded):
    """Simulate with sensitivities; `fold` gathers the rows (dr/db, dr/dpush, r) of every sample.

    b are the coefficients of the equation, the first state and the map of the sensors: however many
    unknowns there are, only these few move the motion. Also what is b by the unknowns.
    """
    row, back = in_a_row(unknowns)

    def setup(row):
        shared, mounting, own = back(row)
        eq = equation(shared, mounting, own, observation, stage)
        moving = [*jax.tree.leaves(eq.ratios), eq.cycle, eq.torque, own.angle, own.angular_velocity]
        return jnp.concatenate([jnp.stack(moving), sensor_map(mounting)]), eq.share

    (begin, share), change = setup(row), jax.jacfwd(lambda row: setup(row)[0])(row) * (1 - known)
    coefficients, sensors = begin[:6], begin[len(MOVING) :]
    count = pushes.begin.shape[0]
    directions = jnp.concatenate([jnp.eye(len(MOVING)), jnp.zeros((count, len(MOVING)))])
    state, by_state = LegState(begin[6], begin[7]), LegState(directions[:, 6], directions[:, 7])
    memory, by_memory = along(chain.begin, (state,), (by_state,))

    def forward(index, carry):
        def step(coefficients, state, missing):
            *ratios, cycle, torque = coefficients
            eq = Equation(Ratios(*ratios), cycle, torque, share)
            return advance(eq, state, index, observation, stage, missing)

        def pushed(leaf):
            return jnp.concatenate([jnp.zeros(len(MOVING)), leaf[:, index]])

        missing = jax.tree.map(jnp.asarray, NOTHING)
        tangents = (directions[:, :6], carry[1], jax.tree.map(pushed, pushes))
        return along(step, (coefficients, carry[0], missing), tangents)

    def gather(index, carry, gathered):
        (memory, by_memory), folded = gathered

        def show(state, memory):
            memory, shown = chain.push(memory, state)
            return memory, shown

        (memory, shown), (by_memory, by_shown) = along(
            show, (carry[0], memory), (carry[1], by_memory)
        )
        value, moved = along(
            lambda shown: residual(shown, sensors, index, observation), (shown,), (by_shown,)
        )
        _, seen = along(
            lambda sensors: residual(shown, sensors, index, observation),
            (sensors,),
            (jnp.eye(len(SHOWING)),),
        )
        size = len(MOVING)
        rows = jnp.concatenate([moved[:size], seen, moved[size:], value[None]])
        return (memory, by_memory), fold(index, rows, folded)

    first = ((memory, by_memory), folded)
    return march(forward, gather, (state, by_state), first, stage.steps)[1], change


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
