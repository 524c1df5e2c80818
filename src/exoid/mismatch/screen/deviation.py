"""How far a segment's simulation stands from the motion that it is pinned to, and its derivatives.

What the simulation does otherwise than the pinned motion x is carried along linearly:

    d(i+1) = F_x d(i) + F_z dz + F_u u(i) + F(x(i)) - x(i+1)

A tether acts on d alone: F_x is then that of a leg tied to the motion.
"""

from dataclasses import replace
from functools import partial
from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
from jax.flatten_util import ravel_pytree
from jaxtyping import Array, Float

from exoid.fitting.data.stage import Stage
from exoid.fitting.misfit.equation import Equation
from exoid.fitting.misfit.residual import advance, residual
from exoid.fitting.misfit.rollout import along, numbers_of
from exoid.fitting.model.coordinates import in_a_row
from exoid.mismatch.screen.measured_motion import FREE
from exoid.physics.motion.step import Drive, march
from exoid.physics.motion.with_terms import Motion
from exoid.physics.state import LegState


class Deviations(eqx.Module):
    """(J, r) at angle and velocity of every sample, and the products of its columns."""

    gram: Float[Any, "*batch column column"]
    rows: Float[Any, "*batch column sample"]


def deviations(
    unknowns, motion, observation, known, pushes, shown, zero, *, stage, chain
) -> Deviations:
    """Of one segment. Its columns are baseline unknowns, zeros of gyro and encoder, terms'
    parameters, residual.

    The last column is no derivative but where the simulation stands beside the motion.
    """
    row, back = in_a_row(unknowns)
    base, terms = row.size, shown.shape[0]

    def setup(row):
        return numbers_of(back(row), observation, FREE)

    (eq, start, sensors), (by_eq, by_start, by_sensors) = along(
        setup, (row,), (jnp.diag(1 - ravel_pytree(known)[0]),)
    )
    pinned = LegState(motion.angle, motion.angular_velocity)
    steppers = jax.vmap(partial(linear_step, eq, by_eq, pinned, observation, stage))
    carry, by_base, by_push, defect = steppers(jnp.arange(motion.angle.size - 1))
    pushed = moved_by(by_push, pushes, eq).at[:, -1].add(defect)
    added = jnp.concatenate([by_base, jnp.zeros_like(by_base[:, :2]), pushed], axis=1)

    begin = jnp.stack(jax.tree.leaves(by_start), axis=1)
    offset = jnp.stack(
        [start.angle - motion.angle[0], start.angular_velocity - pinned.angular_velocity[0]]
    )
    begin = jnp.concatenate([begin, jnp.zeros((2 + terms, 2)).at[-1].set(offset)])

    def forward(index, state):
        return state @ carry[index].T + added[index]

    def store(index, state, folded):
        memory, table = folded
        memory, seen = jax.vmap(chain.push)(memory, LegState(state[:, 0], state[:, 1]))
        return memory, table.at[index].set(jnp.stack([seen.angle, seen.angular_velocity], axis=1))

    memory = jax.vmap(chain.begin)(LegState(begin[:, 0], begin[:, 1]))
    table = jnp.zeros((motion.angle.size, *begin.shape))
    moved = march(forward, store, begin, (memory, table), stage.steps)[1]

    nothing = jnp.zeros((base, *shown.shape[1:]))
    drifting = jnp.zeros((2, *shown.shape[1:])).at[0, :, 1].set(1.0).at[1, :, 0].set(1.0)
    errors = jnp.moveaxis(jnp.concatenate([nothing, drifting, shown]), 0, 1)
    by_sensors = jnp.concatenate([by_sensors, jnp.zeros((2 + terms, 3))])

    def show(index):
        tangents = jnp.moveaxis(moved[index] + errors[index], 1, 0)

        def misfit(angle, velocity, sensors):
            return residual(LegState(angle, velocity), sensors, index, observation)

        here = (motion.angle[index], motion.angular_velocity[index], sensors)
        value, rows = along(misfit, here, (*tangents, by_sensors))
        return rows.at[-1].add(value + zero @ rows[base : base + 2])

    rows = jax.vmap(show)(jnp.arange(motion.angle.size))
    rows = jnp.where(jnp.arange(motion.angle.size)[:, None, None] <= stage.steps, rows, 0.0)
    flat = jnp.moveaxis(rows, 1, 0).reshape(rows.shape[1], -1)
    return Deviations(flat @ flat.T, flat)


def moved_by(by_push, pushes: Drive, eq: Equation) -> Float[Array, "step column state"]:
    """What torques at the stage times of every step do to its end."""
    return jnp.einsum("tsp,pct->tcs", by_push, jnp.stack(jax.tree.leaves(pushes)) / eq.share)


def linear_step(eq, by_eq, pinned, observation, stage, index):
    """One step from the motion: its derivatives by state, by every baseline unknown and by the
    torques at its begin, middle and end, and how far it ends from the motion.
    """

    def step(eq, state, missing):
        return advance(eq, Motion(state, ()), index, observation, FREE, missing).leg

    zero = jnp.zeros(())
    here, after = (jax.tree.map(lambda leaf, i=i: leaf[i], pinned) for i in (index, index + 1))
    following, by_base = along(lambda eq: step(eq, here, Drive(zero, zero, zero)), (eq,), (by_eq,))
    held = tied(eq, stage)
    carry = jax.jacfwd(lambda state: vector(step(held, LegState(*state), Drive(zero, zero, zero))))
    push = jax.jacfwd(lambda missing: vector(step(eq, here, Drive(*missing))))
    defect = vector(following) - vector(after)
    return carry(vector(here)), jnp.stack(jax.tree.leaves(by_base), 1), push(jnp.zeros(3)), defect


def tied(eq: Equation, stage: Stage) -> Equation:
    """The equation of a leg that a critically damped spring holds."""
    ratios = eq.ratios
    held = replace(
        ratios,
        stiffness=ratios.stiffness + stage.tether**2,
        damping=ratios.damping + 2 * stage.tether,
    )
    return replace(eq, ratios=held)


def vector(state: LegState):
    return jnp.stack([state.angle, state.angular_velocity])
