"""The compiled program: every start of a block at once, from a tied simulation to a bounded fit."""

from functools import partial

import equinox as eqx
import jax
import jax.numpy as jnp
from jax.flatten_util import ravel_pytree
from jaxtyping import Array, Bool, Float, Int

from exoid.fit.augmented_lagrangian import minimise
from exoid.fit.chain import Chain
from exoid.fit.condense import Condensed, condense, linear_model
from exoid.fit.constraint import Limits, violations
from exoid.fit.coordinates import (
    Coordinates,
    leg_parameters,
    scaled,
    torque_amplitudes,
    unscaled,
)
from exoid.fit.observation import Observation
from exoid.fit.prior import Prior, prior_residual
from exoid.fit.residual import predict

PENALTY = 100.0  # rho times the variance of a constraint: each round gains two digits
WEAK = 1e-6  # relative curvature that stands in where neither data nor prior has any


class Task(eqx.Module):
    """What a run of the solver is asked to do."""

    noise_scale: Float[Array, ""]  # residuals are divided by it
    tether: Float[Array, ""]  # rad/s
    bounded: Float[Array, ""]  # 1: with prior and limits, 0: the data alone
    tolerance: Float[Array, ""]  # in units of noise
    rounds: Int[Array, ""]  # of multiplier updates


class Solved(eqx.Module):
    """Where every start of the block ended."""

    coordinates: Coordinates
    loss: Float[Array, "*start"]  # half the sum of squares, data and prior
    misfit: Float[Array, "*start"]  # sum of squares of the data residual over their noise
    condensed: Condensed  # at the end point
    multiplier: Float[Array, "*start constraint"]
    violation: Float[Array, "*start"]
    steps: Int[Array, "*start"]
    exhausted: Bool[Array, "*start"]
    angle: Float[Array, "*start segment time"]  # rad, as simulated
    angular_velocity: Float[Array, "*start segment time"]  # rad/s


@partial(jax.jit, static_argnames="chain")
def solve(
    starts: Coordinates,
    observation: Observation,
    known: Float[Array, "segment unknown"],
    prior: Prior,
    limits: Limits,
    task: Task,
    chain: Chain,
) -> Solved:
    """Fit from every start. `starts` carries a leading axis; all else is shared."""
    one = partial(solve_one, chain=chain)
    return jax.vmap(one, in_axes=(0, None, None, None, None, None))(
        starts, observation, known, prior, limits, task
    )


def solve_one(
    start: Coordinates,
    observation: Observation,
    known: Float[Array, "segment unknown"],
    prior: Prior,
    limits: Limits,
    task: Task,
    chain: Chain,
) -> Solved:
    def at(point: Coordinates) -> Condensed:
        one = partial(condense, tether=task.tether, chain=chain)
        fitted = jax.vmap(one, in_axes=(None, 0, 0, 0))(
            unscaled(point).shared, unscaled(point).own, observation, known
        )
        return jax.tree.map(lambda value: value / task.noise_scale, fitted)

    def residual(point: Coordinates):
        # The value is exact at every point, the derivative is that of the linear model there.
        here = jax.lax.stop_gradient(point)
        data = linear_model(at(here), here, point)
        return data, task.bounded * prior_residual(prior, leg_parameters(unscaled(point)))

    def constraint(point: Coordinates):
        free = unscaled(point)
        limit = violations(limits, leg_parameters(free), torque_amplitudes(free))
        return jnp.where(task.bounded > 0, limit, -1.0)

    begin = scaled(start)
    outcome = minimise(
        residual,
        constraint,
        begin,
        jax.lax.cond(
            task.bounded > 0,
            lambda: penalties(residual, constraint, begin),
            lambda: jnp.ones_like(constraint(begin)),
        ),
        tolerance=task.tolerance,
        rounds=task.rounds,
    )
    end = unscaled(outcome.point)
    condensed = at(outcome.point)
    data = jnp.concatenate([condensed.projection.ravel(), condensed.remainder])
    belief = task.bounded * prior_residual(prior, leg_parameters(end))
    simulated = jax.vmap(partial(predict, chain=chain), in_axes=(None, 0, 0, None))(
        end.shared, end.own, observation, task.tether
    )
    return Solved(
        coordinates=end,
        loss=(data @ data + belief @ belief) / 2,
        misfit=data @ data * task.noise_scale**2,
        condensed=condensed,
        multiplier=outcome.multiplier,
        violation=outcome.violation,
        steps=outcome.steps,
        exhausted=outcome.exhausted,
        angle=simulated.angle,
        angular_velocity=simulated.angular_velocity,
    )


def penalties(residual, constraint, point: Coordinates) -> Float[Array, " constraint"]:
    """rho of every constraint: PENALTY over the variance that data and prior leave to it."""
    flat, unravel = ravel_pytree(point)
    value, push = jax.linearize(lambda x: ravel_pytree(residual(unravel(x)))[0], flat)
    del value
    columns = jax.vmap(push)(jnp.eye(flat.size))
    normal = columns @ columns.T
    normal = normal + jnp.diag(WEAK * (1 + jnp.diag(normal)))
    gradients = jax.jacfwd(lambda x: constraint(unravel(x)))(flat)
    spread = jnp.linalg.solve(normal, gradients.T)
    variance = jnp.sum(gradients.T * spread, axis=0)
    return PENALTY / jnp.maximum(variance, WEAK)
