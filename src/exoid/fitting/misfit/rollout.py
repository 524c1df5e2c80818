"""One segment's simulation with its sensitivities: however many unknowns, few numbers move it."""

from collections.abc import Callable
from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
from jax.flatten_util import ravel_pytree
from jaxtyping import Array, Float

from exoid.fitting.data.observation import Observation
from exoid.fitting.data.stage import Stage
from exoid.fitting.misfit.equation import Equation, equation
from exoid.fitting.misfit.residual import (
    NOTHING,
    Shown,
    advance,
    begin,
    glimpse,
    late,
    residual,
    sensor_map,
    shows,
    through,
)
from exoid.fitting.model.coordinates import Unknowns, in_a_row
from exoid.physics.motion.step import march
from exoid.physics.state import LegState


class Rollout(eqx.Module):
    """All that moves a segment's simulation and what its sensors make of it, in one row."""

    coefficients: Float[Array, " coefficient"]
    sensors: Float[Array, " sensor"]
    share: Float[Array, ""]  # of `Equation`
    whole: Callable[[Array], Any] = eqx.field(static=True)  # from the coefficients

    def equation(self, coefficients: Array) -> tuple[Equation, LegState]:
        """The equation and the first state."""
        ratios, cycle, torque, gain, offset, terms, start = self.whole(coefficients)
        return Equation(ratios, cycle, torque, self.share, gain, offset, terms), start


Numbers = tuple[Equation, LegState, Float[Array, "3"]]  # first state, map of the sensors


def of_unknowns(
    unknowns: Unknowns, observation: Observation, known: Unknowns, stage: Stage
) -> tuple[Rollout, Float[Array, "number unknown"]]:
    """The rollout of a segment, and its numbers by the unknowns; `known` ones move nothing."""
    row, back = in_a_row(unknowns)

    def numbers(row) -> Numbers:
        return numbers_of(back(row), observation, stage)

    rollout, change = rollout_of(numbers, row)
    return rollout, change * (1 - ravel_pytree(known)[0])


def numbers_of(unknowns: Unknowns, observation: Observation, stage: Stage) -> Numbers:
    """What a segment's simulation is made of."""
    eq = equation(unknowns, observation, stage)
    start = LegState(unknowns.own.angle, unknowns.own.angular_velocity)
    return eq, start, sensor_map(unknowns.mounting)


def rollout_of(
    numbers: Callable[[Array], Numbers], row: Float[Array, " unknown"]
) -> tuple[Rollout, Float[Array, "number unknown"]]:
    """The coefficients of the equation, the first state and the map of the sensors, and all of
    them by the unknowns: however many these are, only those few move the motion.
    """

    def split(row):
        eq, start, sensors = numbers(row)
        moving = (eq.ratios, eq.cycle, eq.torque, eq.gain, eq.offset, eq.terms, start)
        return moving, sensors, eq.share

    def together(row):
        moving, sensors, _ = split(row)
        return jnp.concatenate([ravel_pytree(moving)[0], sensors])

    moving, sensors, share = split(row)
    coefficients, whole = ravel_pytree(moving)
    return Rollout(coefficients, sensors, share, whole), jax.jacfwd(together)(row)


def sweep(rollout: Rollout, observation, pushes, stage, chain, fold, folded):
    """Simulate with sensitivities; `fold` gathers the rows (dr/db, dr/dpush, r) of every sample, b
    being the coefficients and the map of the sensors, and what is shown before that map.
    """
    size, count = rollout.coefficients.size, pushes.begin.shape[0]
    # What a step needs lies together: (step, direction).
    pushes = jax.tree.map(lambda leaf: jnp.pad(leaf.T, ((0, 0), (size, 0))), pushes)
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

        missing = jax.tree.map(jnp.asarray, NOTHING)
        tangents = (directions, carry[1], jax.tree.map(lambda leaf: leaf[index], pushes))
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
        seen = rows(index, shown.motion, by_shown.motion), shown.motion
        return (memory, by_memory), fold(index, *seen, folded)

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
        return fold(index, rows(index, *now), now[0], folded)

    return march(lambda index, nothing: nothing, count_in, (), folded, stage.steps)


def along(function, primals, tangents):
    """The value of `function` and its derivatives along several directions at once."""

    def one(*direction):
        return jax.jvp(function, primals, direction)

    return jax.vmap(one, out_axes=(None, 0))(*tangents)
