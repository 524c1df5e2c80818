"""A candidate running free: its own simulation of every segment, with exact derivatives."""

from functools import partial
from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
from jaxtyping import Array, Float, Int

from exoid.fitting.data.conditioning_chain import Chain
from exoid.fitting.data.observation import Observation
from exoid.fitting.misfit.residual import equation, sensor_map
from exoid.fitting.model.coordinates import Coordinates, in_a_row, seated
from exoid.mismatch.screen.effect import named
from exoid.mismatch.screen.measured_motion import FREE, Clock, drive_of, place_of
from exoid.physics.motion.step import Drive, march
from exoid.physics.motion.with_terms import at_rest, delayed, extended_step, observed
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
    known: Float[Array, "segment unknown"],
    clock: Clock,
    steps: Int[Array, ""],
    static: tuple[tuple[type[Term], ...], Chain],
) -> Released:
    """A candidate's misfit and derivatives, and the motion that its sensors would show.

    Columns as in `pinned`: baseline unknowns, zeros of gyro and encoder, terms' parameters,
    residual.
    """
    terms, chain = static

    mounting = jax.vmap(seated, in_axes=(None, 0))(point.mounting, observation.seat)
    each: Any = partial(segment, terms, chain, steps)
    by_segment = jax.vmap(each, in_axes=(None, None, None, 0, 0, 0, 0, 0))
    gram, shown = by_segment(
        values, zero, point.shared, mounting, point.own, observation, known, clock
    )
    return Released(gram, shown)


def segment(terms, chain, steps, values, zero, shared, mounting, own, observation, known, clock):
    """One segment's products and what its sensors would show."""
    base, back = in_a_row((shared, mounting, own))
    sizes = [value.size for value in values]
    weights = jnp.stack([observation.angle_weight, observation.velocity_weight], axis=1)
    data = jnp.stack([observation.angle, observation.angular_velocity], axis=1)

    def shown(unknowns):
        shared, mounting, own = back(unknowns[: base.size])
        zero, *numbers = jnp.split(unknowns[base.size :], np.cumsum([2, *sizes])[:-1])
        each = tuple(named(term, value) for term, value in zip(terms, numbers, strict=True))
        found = simulate(each, shared, mounting, own, zero, observation, clock, chain, steps)
        return found, found

    unknowns = jnp.concatenate([base, zero, *values])
    slopes, motion = jax.jacfwd(shown, has_aux=True)(unknowns)
    moving = jnp.concatenate([1 - known, jnp.ones(unknowns.size - base.size)])
    used = weights > 0
    rows = jnp.where(used[..., None], weights[..., None] * slopes * moving, 0.0)
    misfit = jnp.where(used, weights * (motion - data), 0.0)
    table = jnp.concatenate([rows, misfit[..., None]], axis=-1).reshape(-1, unknowns.size + 1)
    return table.T @ table, motion


def simulate(terms, shared, mounting, own, offset, observation, clock, chain, steps):
    """What encoder and gyro would show of one segment: (time, channel)."""
    eq = equation(shared, mounting, own, observation, FREE)
    place, drive = place_of(eq, clock), drive_of(eq, observation)
    time = observation.time
    pushed = jnp.append(drive.begin, drive.end[-1])

    def forward(index, motion):
        push = Drive(drive.begin[index], drive.middle[index], drive.end[index])
        step = time[index + 1] - time[index]
        return extended_step(place, terms, motion, time[index], step, push)

    def store(index, motion, folded):
        memory, table = folded
        seen = observed(place, terms, motion, time[index], pushed[index])
        memory, now = chain.push(memory, LegState(seen.shown_angle, seen.shown_velocity))
        row = jnp.stack([now.angle, now.angular_velocity, seen.shown_acceleration, seen.delay])
        return memory, table.at[index].set(row)

    leg = LegState(own.angle, own.angular_velocity)
    begin = at_rest(place, terms, leg, time[0], pushed[0])
    first = observed(place, terms, begin, time[0], pushed[0])
    memory = chain.begin(LegState(first.shown_angle, first.shown_velocity))
    empty = (memory, jnp.zeros((time.size, 4)))
    angle, velocity, acceleration, delay = march(forward, store, begin, empty, steps)[1].T
    zero, scale, bias = sensor_map(mounting)
    velocity = delayed(time, velocity, acceleration, delay)
    velocity = (1 + scale) * velocity + bias + offset[0]
    return jnp.stack([angle + zero + offset[1], velocity], axis=1)
