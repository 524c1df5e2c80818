"""Would the same cause be found had other segments been recorded?"""

import numpy as np
from jaxtyping import Float

from exoid.mismatch.screen.hypothesis import Optimum
from exoid.mismatch.screen.optimise import WEAK, bounded
from exoid.mismatch.search.found import Found, size

DRAWS = 200
FEWEST = 3  # segments, of which fewer make no sample

Parts = Float[np.ndarray, "part column column"]


def inclusion(found: Found, same: list[Optimum], rivals: list[Optimum], seed: int) -> float | None:
    """The share of bootstrapped sets of segments in which one of the `same` has the most evidence.

    Each candidate is refitted to every set by its quadratic model. None where there are too few
    segments.
    """
    count = found.prepared.segments
    if count < FEWEST:
        return None
    draws = np.random.default_rng(seed).multinomial(count, np.ones(count) / count, DRAWS)
    best = [
        np.max([worths(found, one, one.products.each, draws) for one in side], axis=0)
        for side in (same, rivals)
    ]
    return float(np.mean(best[0] >= best[1]))


def worths(found: Found, one: Optimum, parts: Parts, draws: np.ndarray) -> np.ndarray:
    """Minus what a candidate leaves of every set that was drawn, and minus its price."""
    at = one.candidate.unknowns
    lower, upper = found.prepared.bounds(one.candidate)
    total = np.tensordot(draws, parts, axes=1)
    normal, gradient, square = total[:, :-1, :-1], total[:, :-1, -1], total[:, -1, -1]
    change = steps(normal, gradient, lower - at, upper - at)
    left = square + np.einsum("di,di->d", change, 2 * gradient + matvec(normal, change))
    return -left / found.yardstick.scale - found.yardstick.price(size(one))


def steps(
    normal: np.ndarray, gradient: np.ndarray, lower: np.ndarray, upper: np.ndarray
) -> np.ndarray:
    """`bounded` of many at once, most of which run into no bound."""
    size = np.sqrt(np.diagonal(normal, axis1=1, axis2=2))
    unit = np.where(size > 0, size, 1.0)
    scaled = normal / (unit[:, :, None] * unit[:, None, :]) + WEAK * np.eye(lower.size)
    change = -np.linalg.solve(scaled, (gradient / unit)[..., None])[..., 0] / unit
    for beyond in np.flatnonzero(((change < lower) | (change > upper)).any(axis=1)):
        change[beyond] = bounded(normal[beyond], gradient[beyond], 0.0, lower, upper)
    return change


def matvec(matrix: np.ndarray, vector: np.ndarray) -> np.ndarray:
    return np.einsum("dij,dj->di", matrix, vector)
