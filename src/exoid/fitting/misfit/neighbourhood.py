"""The neighbourhood of a point of the fit: what penalties and standard errors are made of."""

from collections.abc import Callable
from dataclasses import replace

import jax
import numpy as np
from jaxtyping import Float, Int
from scipy.linalg import block_diag

from exoid.fitting.misfit.condensed import Condensed, Neighbourhood
from exoid.fitting.model.constraint import violations_at
from exoid.fitting.model.coordinates import (
    Coordinates,
    by_segment,
    flattened,
    layout,
    places,
    quantities,
    unflattened,
)
from exoid.fitting.model.limits import Limits, Prior
from exoid.fitting.model.prior import belief_residual, mounting_residual

COMPLEX_STEP = 1e-30  # exact to rounding: no difference is taken
PENALTY = 100.0  # rho times the variance of a constraint: each round gains two digits
WEAK = 1e-6  # relative curvature that stands in where neither data nor prior has any


def neighbourhood(
    point: Coordinates,
    condensed: Condensed,
    owner: Int[np.ndarray, " segment"],
    prior: Prior,
    limits: Limits,
) -> Neighbourhood:
    """The derivatives at `point` (no leading axis), where the misfit condenses to `condensed`."""

    counts: list[int] = []

    def parts(at: Coordinates) -> np.ndarray:
        each = [
            belief_residual(prior, at, np),
            quantities(at, np),
            violations_at(limits, at, np),
        ]
        counts.extend(len(one) for one in each)
        return np.concatenate(each)

    with np.errstate(invalid="ignore"):  # infinite limits are no limits
        every = gradients(parts, point)
    belief, by_quantity, by_constraint = np.split(every, np.cumsum(counts)[:-1])
    slopes = declared_slopes(point, prior)
    declared = slopes.T @ slopes
    return Neighbourhood(
        data=told(condensed, columns(point, owner), layout(point).size),
        prior=belief.T @ belief + declared,
        declared=declared,
        quantities=by_quantity,
        constraints=by_constraint,
    )


def declared_slopes(point: Coordinates, prior: Prior) -> np.ndarray:
    """The derivatives of `mounting_residual`, which is linear: (row, coordinate)."""
    laid = layout(point)
    if prior.mounting is None:
        return np.zeros((0, laid.size))
    own = flattened(laid.places.mounting)
    slopes = np.zeros((own.size, laid.size))
    whitening = block_diag(*jax.tree.leaves(prior.in_common))
    slopes[:, own] = whitening * laid.units[own] / flattened(prior.mounting)
    return slopes


def prior_information(point: Coordinates, prior: Prior) -> np.ndarray:
    """What is believed of leg and mountings, around `point`."""

    believed = gradients(lambda at: belief_residual(prior, at, np), point)
    declared = declared_slopes(point, prior)
    return believed.T @ believed + declared.T @ declared


def pull_of_belief(point: Coordinates, prior: Prior) -> np.ndarray:
    """The gradient of half the sum of squares of what is believed of leg and mountings."""
    believed = gradients(lambda at: belief_residual(prior, at, np), point)
    off = believed.T @ belief_residual(prior, point, np)
    return off + declared_slopes(point, prior).T @ mounting_residual(prior, point.mounting, np)


def quantity_gradients(point: Coordinates) -> np.ndarray:
    """d of `coordinates.quantities`: (quantity, coordinate)."""
    return gradients(lambda at: quantities(at, np), point)


def gradients(function: Callable[[Coordinates], np.ndarray], point: Coordinates) -> np.ndarray:
    """The Jacobian of a function of the coordinates, in the units that the solver sees."""
    units = layout(point).units
    return derivative(
        lambda steps: function(unflattened(steps * units[:, None], point)),
        flattened(point) / units,
    )


def weighed(local: Neighbourhood, scale: float) -> Neighbourhood:
    """The same where the residual counts 1 / `scale`."""
    return replace(local, data=local.data / scale**2)


def derivative(function: Callable, at: np.ndarray) -> np.ndarray:
    """The Jacobian (output, input) of a smooth NumPy function, by the complex step.

    The function is called once, with every step as a column of its own.
    """
    steps = at[:, None] + 1j * COMPLEX_STEP * np.eye(at.size)
    return function(steps).imag / COMPLEX_STEP


def columns(point: Coordinates, owner: Int[np.ndarray, " segment"]) -> np.ndarray:
    """Which coordinate every unknown of every segment is: (segment, unknown)."""
    return by_segment(places(point), owner, np)


def told(condensed: Condensed, columns: np.ndarray, size: int) -> np.ndarray:
    """The sum over segments of R'R, each placed at the coordinates that the segment has."""
    total = np.zeros((size, size))
    for place, factor in zip(columns, np.asarray(condensed.factor), strict=True):
        total[np.ix_(place, place)] += factor.T @ factor
    return total


def penalties(local: Neighbourhood) -> Float[np.ndarray, " constraint"]:
    """rho of every constraint: PENALTY over the variance that data and prior leave to it."""
    total = local.data + local.prior
    total = total + np.diag(WEAK * (1 + np.diag(total)))
    spread = np.linalg.solve(total, local.constraints.T)
    variance = np.sum(local.constraints.T * spread, axis=0)
    return PENALTY / np.maximum(variance, WEAK)
