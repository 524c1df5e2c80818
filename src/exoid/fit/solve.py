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
from exoid.fit.constraint import NEVER, Limits, violations
from exoid.fit.coordinates import (
    Coordinates,
    leg_parameters,
    scaled,
    torque_amplitudes,
    unscaled,
)
from exoid.fit.observation import Observation
from exoid.fit.prior import Prior, prior_residual
from exoid.fit.residual import Stage, predict
from exoid.physics.leg import LegParameters

PENALTY = 100.0  # rho times the variance of a constraint: each round gains two digits
WEAK = 1e-6  # relative curvature that stands in where neither data nor prior has any


class Task(eqx.Module):
    """What a run of the solver is asked to do."""

    noise_scale: Float[Array, ""]  # residuals are divided by it
    stage: Stage
    bounded: Float[Array, ""]  # 1: with prior and limits, 0: the data alone
    tolerance: Float[Array, ""]  # in units of noise
    rounds: Int[Array, ""]  # of multiplier updates
    information: Condensed  # of the free fit that came before; it sets the penalties


class Local(eqx.Module):
    """The end point's neighbourhood in scaled coordinates: what standard errors are made of."""

    data: Float[Array, "*start coordinate coordinate"]  # Gauss-Newton information of the misfit
    prior: Float[Array, "*start coordinate coordinate"]  # of the prior
    parameters: Float[Array, "*start parameter coordinate"]  # d (P, tau of each segment)
    ratios: Float[Array, "*start ratio coordinate"]  # d (m l g, c, d, tau of each segment) / J
    constraints: Float[Array, "*start constraint coordinate"]  # d g


class Solved(eqx.Module):
    """Where every start of the block ended."""

    coordinates: Coordinates
    leg: LegParameters
    torque: Float[Array, "*start segment"]  # N m
    loss: Float[Array, "*start"]  # half the sum of squares, data and prior
    misfit: Float[Array, "*start"]  # sum of squares of the data residual over their noise
    condensed: Condensed  # at the end point
    multiplier: Float[Array, "*start constraint"]
    violation: Float[Array, "*start"]
    steps: Int[Array, "*start"]
    exhausted: Bool[Array, "*start"]
    local: Local
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
        each = jax.vmap(partial(condense, stage=task.stage, chain=chain), in_axes=(None, 0, 0, 0))
        condensed = each(point.shared, point.own, observation, known)
        return jax.tree.map(lambda value: value / task.noise_scale, condensed)

    def residual(point: Coordinates):
        # The value is exact at every point, the derivative is that of the linear model there.
        here = jax.lax.stop_gradient(point)
        condensed = at(unscaled(here))
        belief = prior_residual(prior, leg_parameters(unscaled(point)))
        value = linear_model(condensed, here, point), task.bounded * belief
        return value, (value, condensed)

    def constraint(point: Coordinates):
        free = unscaled(point)
        limit = violations(limits, leg_parameters(free), torque_amplitudes(free))
        return jnp.where(task.bounded > 0, limit, NEVER)

    outcome = minimise(
        residual,
        constraint,
        scaled(start),
        nothing_unless(
            task.bounded > 0,
            lambda: penalties(task.information, prior, constraint, scaled(start)),
        )
        + (1 - task.bounded),
        tolerance=task.tolerance,
        rounds=task.rounds,
    )
    (data, belief), condensed = outcome.detail
    end = unscaled(outcome.point)
    free = Stage(jnp.zeros_like(task.stage.tether), task.stage.steps)
    simulated = jax.vmap(partial(predict, stage=free, chain=chain), in_axes=(None, 0, 0))(
        end.shared, end.own, observation
    )
    return Solved(
        coordinates=end,
        leg=leg_parameters(end),
        torque=torque_amplitudes(end),
        loss=(data @ data + belief @ belief) / 2,
        misfit=data @ data * task.noise_scale**2,
        condensed=condensed,
        multiplier=outcome.multiplier,
        violation=outcome.violation,
        steps=outcome.steps,
        exhausted=outcome.exhausted,
        local=nothing_unless(
            task.bounded > 0,
            lambda: neighbourhood(outcome.point, condensed, prior, constraint),
        ),
        angle=simulated.angle,
        angular_velocity=simulated.angular_velocity,
    )


def nothing_unless(wanted: Bool[Array, ""], compute):
    """What `compute` gives, or zeros of its shape at no cost."""
    zeros = jax.tree.map(lambda leaf: jnp.zeros(leaf.shape, leaf.dtype), jax.eval_shape(compute))
    return jax.lax.cond(wanted, compute, lambda: zeros)


def neighbourhood(point: Coordinates, condensed: Condensed, prior: Prior, constraint) -> Local:
    """First derivatives at `point` of all that is reported."""
    flat, unravel = ravel_pytree(point)

    def data(x):
        return linear_model(condensed, point, unravel(x))

    def belief(x):
        return prior_residual(prior, leg_parameters(unscaled(unravel(x))))

    def parameters(x):
        free = unscaled(unravel(x))
        return jnp.stack([*jax.tree.leaves(leg_parameters(free)), *torque_amplitudes(free)])

    def ratios(x):
        free = unscaled(unravel(x))
        shared = free.shared
        return jnp.stack([shared.gravity, shared.stiffness, shared.damping, *free.own.torque])

    by_data, by_prior, by_parameters, by_ratios, by_constraint = (
        jax.jacfwd(function)(flat)
        for function in (data, belief, parameters, ratios, lambda x: constraint(unravel(x)))
    )
    return Local(
        by_data.T @ by_data, by_prior.T @ by_prior, by_parameters, by_ratios, by_constraint
    )


def penalties(
    information: Condensed, prior: Prior, constraint, point: Coordinates
) -> Float[Array, " constraint"]:
    """rho of every constraint: PENALTY over the variance that data and prior leave to it."""
    local = neighbourhood(point, information, prior, constraint)
    total = local.data + local.prior
    total = total + jnp.diag(WEAK * (1 + jnp.diag(total)))
    spread = jnp.linalg.solve(total, local.constraints.T)
    variance = jnp.sum(local.constraints.T * spread, axis=0)
    return PENALTY / jnp.maximum(variance, WEAK)
