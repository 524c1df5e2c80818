"""Would the same cause be found had other segments been recorded?"""

import numpy as np
from jaxtyping import Float

from exoid.mismatch.screen.hypothesis import Optimum
from exoid.mismatch.screen.optimise import bounded
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

    def left(draw: np.ndarray) -> float:
        total = np.tensordot(draw, parts, axes=1)
        normal, gradient, square = total[:-1, :-1], total[:-1, -1], total[-1, -1]
        change = bounded(normal, gradient, 0.0, lower - at, upper - at)
        return float(square + 2 * gradient @ change + change @ normal @ change)

    return -np.array(list(map(left, draws))) / found.yardstick.scale - found.yardstick.price(
        size(one)
    )
