"""A segment's misfit and its derivatives at one point, as what is asked of them needs them."""

from collections.abc import Callable
from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
from jax.flatten_util import ravel_pytree
from jaxtyping import Array, Float

from exoid.fitting.data.observation import Observation
from exoid.fitting.misfit.residual import (
    Equation,
    equation,
    sensor_map,
)
from exoid.fitting.misfit.stage import Stage
from exoid.fitting.model.coordinates import Unknowns, in_a_row
from exoid.physics.state import LegState


class Condensed(eqx.Module):
    """R, Q'r and the rest of one segment's residual, in units of noise and of `typical`."""

    factor: Float[Any, "*batch unknown unknown"]
    projection: Float[Any, "*batch unknown"]
    remainder: Float[Any, "*batch"]


class Sensed(eqx.Module):
    """The residual of every sample, and its derivatives, in units of noise and of `typical`."""

    residual: Float[Any, "*segment time channel"]
    columns: Float[Any, "*segment unknown time channel"]
    responses: Float[Any, "*segment push time channel"]  # to missing torques


class Rollout(eqx.Module):
    """All that moves a segment's simulation and what its sensors make of it, in one row."""

    coefficients: Float[Array, " coefficient"]
    sensors: Float[Array, " sensor"]
    share: Float[Array, ""]  # of `Equation`
    whole: Callable[[Array], Any] = eqx.field(static=True)  # from the coefficients

    def equation(self, coefficients: Array) -> tuple[Equation, LegState]:
        """The equation and the first state."""
        ratios, cycle, torque, terms, start = self.whole(coefficients)
        return Equation(ratios, cycle, torque, self.share, terms), start


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
        return (eq.ratios, eq.cycle, eq.torque, eq.terms, start), sensors, eq.share

    def together(row):
        moving, sensors, _ = split(row)
        return jnp.concatenate([ravel_pytree(moving)[0], sensors])

    moving, sensors, share = split(row)
    coefficients, whole = ravel_pytree(moving)
    return Rollout(coefficients, sensors, share, whole), jax.jacfwd(together)(row)
