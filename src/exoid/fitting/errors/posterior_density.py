"""The density that a posterior is drawn from, in coordinates of unit scale around the best fit."""

from dataclasses import replace
from functools import partial
from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
from jax.flatten_util import ravel_pytree
from jaxtyping import Array, Float

from exoid.fitting.data.conditioning_chain import Chain
from exoid.fitting.data.observation import Observation
from exoid.fitting.data.stage import Stage
from exoid.fitting.misfit.condense import condense, linear_model, weighed
from exoid.fitting.misfit.neighbourhood import columns, prior_information
from exoid.fitting.misfit.uncertainty import whitening
from exoid.fitting.model.belief import NAMES, Belief
from exoid.fitting.model.constraint import SIZE, violations_at
from exoid.fitting.model.coordinates import (
    Coordinates,
    Unknowns,
    flattened,
    layout,
    leg_parameters,
    of_segments,
    places,
    scaled,
    unflattened,
    unscaled,
)
from exoid.fitting.model.limits import Limits, Prior
from exoid.fitting.model.prior import (
    belief_residual,
    log_jacobian,
    mounting_residual,
    term_log_jacobian,
)
from exoid.fitting.model.systematics import FOOT, SLANT
from exoid.fitting.model.term_parameters import parameters_of, step_of, with_values
from exoid.fitting.multistart.seldom import may_be_slanted
from exoid.fitting.result.estimates.basis import Basis
from exoid.fitting.solve.ask import around, take
from exoid.fitting.solve.problem import Problem

UNDETERMINED = 1e-3  # information per typical step squared, too little to sample along
NARROW = 2e-4  # relative width of what a user fixed: chains cannot move along a surface
UNIFORM = 12.0  # squared width over variance of a uniform density


class Target(eqx.Module):
    """The density of y, where best + spread y are the fit's scaled coordinates."""

    best: Coordinates  # scaled
    spread: Float[Any, "coordinate direction"]
    shrink: Float[Any, "coordinate coordinate"]  # C of `posterior.sample`
    tilt: Float[Any, " coordinate"]  # keeps the data's slope at the best fit
    scale: Float[Any, " segment"]
    observation: Observation
    known: Unknowns
    stage: Stage
    prior: Prior
    limits: Limits
    seats: Float[Any, "seat recording"]  # 1 on each that a foot may have put a leg's line off


def posed(basis: Basis) -> tuple[Target, np.ndarray]:
    """The density, and the directions (coordinate, direction) that nothing determines."""
    problem, ended = basis.problem, basis.ended
    local = ended.local
    prior, limits = without_fixed(problem.belief)
    moving = unknown(problem, ended.point)
    total = (local.data + prior_information(ended.point, prior))[np.ix_(moving, moving)]
    values, vectors = np.linalg.eigh(total)
    loose = vectors[:, values < UNDETERMINED]
    bounds = (limits.lower, limits.upper, SIZE)
    width = jax.tree.leaves(jax.tree.map(lambda low, high, size: (high - low) / size, *bounds))
    edges = local.constraints[: len(width), moving] @ loose / np.array(width)[:, None]
    values, vectors = np.linalg.eigh(total + UNIFORM * loose @ edges.T @ edges @ loose.T)
    kept = values >= UNDETERMINED
    vectors = np.eye(len(local.data))[:, moving] @ vectors
    shrink, tilt = curved(basis)
    target = Target(
        best=scaled(ended.point),
        spread=vectors[:, kept] / np.sqrt(values[kept]),
        shrink=shrink,
        tilt=tilt,
        scale=ended.disturbance.scale * ended.disturbance.weighing(problem.kinds),
        observation=problem.observation,
        known=problem.known,
        stage=problem.free,
        prior=prior,
        limits=limits,
        seats=seats_of(problem),
    )
    return target, vectors[:, ~kept]


def unknown(problem: Problem, point: Coordinates) -> np.ndarray:
    """The coordinates that are no exact ones of a recording: those never move."""
    numbers = places(point).mounting
    exact = [
        int(getattr(numbers, name)[entry])
        for name in problem.owned
        for entry in range(len(problem.recordings))
        if not problem.estimates(name, entry)
    ]
    return np.setdiff1d(np.arange(layout(point).size), exact)


def seats_of(problem: Problem) -> np.ndarray:
    """Which recordings are on each seat on which the line of a leg may be off."""
    entries = may_be_slanted(problem)
    seats = np.zeros((len(entries), len(problem.recordings)))
    for row, entry in zip(seats, entries, strict=True):
        row[entry] = 1.0
    return seats


def without_fixed(belief: Belief) -> tuple[Prior, Limits]:
    """What was fixed as a narrow belief, in the place of limits that leave nothing between them."""
    fixed, prior, limits = belief.by_hand.fix, belief.prior, belief.limits
    if not fixed:
        return prior, limits
    weight = float(prior.weight) or 1.0
    terms = parameters_of([type(term) for term in limits.lower_terms])
    sizes = {name: float(getattr(SIZE, name)) for name in NAMES}
    sizes |= {name: step_of(declared) for name, declared in terms}
    width = {
        name: NARROW * (abs(value) or sizes[name]) * np.sqrt(weight)
        for name, value in fixed.items()
    }
    prior = replace(
        prior,
        own=with_values(prior.own, fixed),
        own_deviation=with_values(prior.own_deviation, width),
        terms=tuple(with_values(each, fixed) for each in prior.terms),
        terms_deviation=tuple(with_values(each, width) for each in prior.terms_deviation),
        weight=np.asarray(weight),
    )
    lowest, highest = dict.fromkeys(fixed, -np.inf), dict.fromkeys(fixed, np.inf)
    return prior, replace(
        limits,
        lower=with_values(limits.lower, lowest),
        upper=with_values(limits.upper, highest),
        lower_terms=tuple(with_values(each, lowest) for each in limits.lower_terms),
        upper_terms=tuple(with_values(each, highest) for each in limits.upper_terms),
    )


def curved(basis: Basis) -> tuple[np.ndarray, np.ndarray]:
    """C with C'HC = W, of the misfit's H and the fit's W, and the slope that C would change."""
    best = basis.ended.best
    plain = around(basis.problem, best).data
    white, unit = whitening(plain)
    inward, outward = white / unit[:, None], np.linalg.pinv(white).T * unit[:, None]
    values, axes = np.linalg.eigh(inward.T @ basis.ended.local.data @ inward)
    root = np.sqrt(np.maximum(values, 0.0))  # beyond 1 where a kind was held for worse than it is
    change = (axes * root) @ axes.T - np.eye(root.size)
    shrink = np.eye(len(plain)) + inward @ change @ outward.T
    one, slope = take(best, 0), np.zeros(len(plain))
    places_of = columns(one.coordinates, basis.problem.observation.owner)
    for at, factor, projection in zip(
        places_of, one.condensed.factor, one.condensed.projection, strict=True
    ):
        slope[at] += factor.T @ projection
    return shrink, slope - shrink.T @ slope


def log_density(
    target: Target, chain: Chain, place: Float[Array, " direction"]
) -> Float[Array, ""]:
    """Its derivative is exact: where the misfit is condensed, its linear model has the same."""
    flat, unravel = ravel_pytree(target.best)
    change = target.spread @ place
    point, to = unscaled(unravel(flat + change)), unravel(flat + target.shrink @ change)
    here = jax.lax.stop_gradient(to)
    at, seen = unscaled(here), target.observation
    each = partial(condense, stage=target.stage, chain=chain)
    condensed = jax.vmap(each)(of_segments(at, seen.owner), seen, target.known)
    leg, prior = leg_parameters(point), target.prior
    data = linear_model(weighed(condensed, target.scale), here, to, seen.owner)
    belief = belief_residual(prior, point), mounting_residual(prior, point.mounting)
    loss = sum(jnp.sum(part**2) for part in (data, *belief)) / 2 + target.tilt @ change
    within = violations_at(target.limits, point).max() <= 0
    volume = log_jacobian(prior, leg) + term_log_jacobian(prior, point)
    likely = volume - loss + slanted_too(target, point.mounting.tilt)
    return jnp.where(within, likely, -jnp.inf)


def slanted_too(target: Target, tilt: Float[Array, " recording"]) -> Float[Array, ""]:
    """log of p(tilts) over that of level seats alone: a part of all legs has a foot that puts their
    line off, p = (1 - F) N(0, level) + F N(0, slant).
    """
    seats, deviation, alike = target.seats, target.prior.mounting, target.prior.in_common
    if not len(seats) or deviation is None or alike is None:
        return jnp.zeros(())
    each = seats.sum(axis=1)
    level = seats @ deviation.tilt / each / SLANT
    square = seats @ (alike.tilt @ (tilt / deviation.tilt)) ** 2
    wider = each * jnp.log(level) + square * (1 - level**2) / 2
    return jnp.logaddexp(jnp.log1p(-FOOT), jnp.log(FOOT) + wider).sum()


def points(target: Target, places: np.ndarray) -> Coordinates:
    """The coordinates of many places, which become the last axis."""
    flat = flattened(target.best)[:, None] + target.spread @ places.T
    return unscaled(unflattened(flat, target.best))
