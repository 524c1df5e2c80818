"""Would the same cause be found had other segments been recorded?"""

import numpy as np

from exoid.mismatch.screen.hypothesis import Optimum
from exoid.mismatch.screen.optimise import bounded
from exoid.mismatch.search.found import Found, size

DRAWS = 200
FEWEST = 3  # segments, of which fewer make no sample


def inclusion(found: Found, same: list[Optimum], rivals: list[Optimum], seed: int) -> float | None:
    """The share of bootstrapped sets of segments in which one of the `same` has the most evidence.

    Each candidate is refitted to every set by its quadratic model. None where there are too few
    segments.
    """
    count = found.prepared.segments
    if count < FEWEST:
        return None
    draws = np.random.default_rng(seed).multinomial(count, np.ones(count) / count, DRAWS)
    most = [
        np.max([[worth(found, one, draw) for draw in draws] for one in each], axis=0)
        for each in (same, rivals)
    ]
    return float(np.mean(most[0] >= most[1]))


def worth(found: Found, one: Optimum, draw: np.ndarray) -> float:
    """Minus what a candidate leaves of a set of segments, and minus its price."""
    total = np.tensordot(draw, one.products.each, axes=1)
    normal, gradient, square = total[:-1, :-1], total[:-1, -1], total[-1, -1]
    at = one.candidate.unknowns
    lower, upper = found.prepared.bounds(one.candidate)
    change = bounded(normal, gradient, 0.0, lower - at, upper - at)
    left = square + 2 * gradient @ change + change @ normal @ change
    return -float(left) / found.yardstick.scale - found.yardstick.price(size(one))
