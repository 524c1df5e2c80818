"""The compiled program: every start of a block at once, from a tied simulation to a bounded fit."""

from dataclasses import replace
from functools import partial

import jax
import jax.numpy as jnp
from jax.flatten_util import ravel_pytree
from jaxtyping import Array, Float, Int

from exoid.fitting.data.conditioning_chain import Chain
from exoid.fitting.data.observation import Observation
from exoid.fitting.data.stage import Stage
from exoid.fitting.misfit.condense import condense, linear_model, misfit, sense, weighed
from exoid.fitting.misfit.condensed import Condensed, Sensed, Triangles
from exoid.fitting.misfit.gram_matrices import pushes, triangles
from exoid.fitting.misfit.residual import predict
from exoid.fitting.model.constraint import NEVER, term_violations, violations
from exoid.fitting.model.coordinates import (
    Coordinates,
    Unknowns,
    leg_parameters,
    of_segments,
    quantities,
    scaled,
    torque_amplitudes,
    unscaled,
)
from exoid.fitting.model.limits import Limits, Prior
from exoid.fitting.model.prior import belief_residual, mounting_residual
from exoid.fitting.solve.augmented_lagrangian import minimise
from exoid.fitting.solve.program_values import Solved, StartRequest, Task
from exoid.physics.motion.step import Drive


@partial(jax.jit, static_argnames="chain")
def solve(
    starts: Coordinates,
    requests: StartRequest,
    observation: Observation,
    known: Unknowns,
    prior: Prior,
    limits: Limits,
    task: Task,
    chain: Chain,
) -> Solved:
    """Fit from every start. `starts` and `requests` carry a leading axis; all else is shared."""

    def one(start: Coordinates, request: StartRequest) -> Solved:
        return solved_from(start, request, observation, known, prior, limits, task, chain)

    return jax.vmap(one)(starts, requests)


@partial(jax.jit, static_argnames="chain")
def solve_many(each: tuple, steps: Int[Array, ""], chain: Chain) -> Solved:
    """`solve` of many fits at once: every start, by a leading axis, has arguments of its own.

    `steps` are the most of all tasks; what is beyond its own weighs nothing.
    """

    def one(start, request, observation, known, prior, limits, task) -> Solved:
        inside = jnp.arange(observation.time.shape[-1]) <= task.stage.steps
        observation = observation.weighed(inside)
        task = replace(task, stage=replace(task.stage, steps=steps))
        return solved_from(start, request, observation, known, prior, limits, task, chain)

    return jax.vmap(lambda own: one(*own))(each)


def solved_from(
    start: Coordinates,
    request: StartRequest,
    observation: Observation,
    known: Unknowns,
    prior: Prior,
    limits: Limits,
    task: Task,
    chain: Chain,
) -> Solved:
    """Where the fit from one start ends."""

    def at(point: Coordinates) -> Condensed:
        each = partial(condense, stage=task.stage, chain=chain)
        condensed = jax.vmap(each)(of_segments(point, observation.owner), observation, known)
        return weighed(condensed, request.noise_scale)

    def residual(flat):
        # The value is exact at every point, the derivative is that of the linear model there.
        point = unravel(flat)
        here = jax.lax.stop_gradient(point)
        condensed = at(unscaled(here))
        data = linear_model(condensed, here, point, observation.owner)
        believed = unscaled(point)
        expected = task.bounded * belief_residual(prior, believed)
        belief = jnp.concatenate([expected, mounting_residual(prior, believed.mounting)])
        pull = request.strength * (request.weights @ quantities(believed) - request.target)
        detail = (condensed, data @ data, belief @ belief)
        return jnp.concatenate([data, belief, pull[None]]), detail

    def constraint(flat):
        point = unscaled(unravel(flat))
        limit = violations(limits, leg_parameters(point), torque_amplitudes(point))
        of_leg = jnp.where(task.bounded > 0, limit, NEVER)
        return jnp.concatenate([of_leg, term_violations(limits, point)])

    begin, unravel = ravel_pytree(scaled(start))
    outcome = minimise(
        residual, constraint, begin, task.penalty, tolerance=task.tolerance, rounds=task.rounds
    )
    condensed, data, belief = outcome.detail
    end = unscaled(unravel(outcome.point))
    free = replace(task.stage, tether=jnp.zeros_like(task.stage.tether))
    simulated = jax.vmap(partial(predict, stage=free, chain=chain))(
        of_segments(end, observation.owner), observation
    )
    return Solved(
        coordinates=end,
        leg=leg_parameters(end),
        torque=torque_amplitudes(end),
        quantities=quantities(end),
        loss=(data + belief) / 2,
        misfit=misfit(weighed(condensed, 1 / request.noise_scale)),
        condensed=condensed,
        noise_scale=request.noise_scale,
        multiplier=outcome.multiplier,
        violation=outcome.violation,
        steps=outcome.steps,
        exhausted=outcome.exhausted,
        angle=simulated.angle,
        angular_velocity=simulated.angular_velocity,
    )


@partial(jax.jit, static_argnames="chain")
def sense_all(
    point: Coordinates,
    observation: Observation,
    known: Unknowns,
    pushes: Drive,
    stage: Stage,
    chain: Chain,
) -> Sensed:
    """Residual and sensitivities of every sample of every segment, at one point."""
    each = partial(sense, stage=stage, chain=chain)
    return jax.vmap(each)(of_segments(point, observation.owner), observation, known, pushes)


@partial(jax.jit, static_argnames="chain")
def triangles_all(
    point: Coordinates,
    observation: Observation,
    known: Unknowns,
    nodes: Float[Array, "segment node"],
    stage: Stage,
    chain: Chain,
) -> Triangles:
    """The triangles of every segment at one point, with these times of nodes."""

    def one(unknowns, observation, known, nodes) -> Triangles:
        push = pushes(observation.time, nodes, jnp)
        sensed = sense(unknowns, observation, known, push, stage, chain)
        return triangles(sensed, observation, nodes, jnp)

    return jax.vmap(one)(of_segments(point, observation.owner), observation, known, nodes)
