"""Would the same cause be found had other segments, or other stretches of time, been recorded?"""

import numpy as np
from jaxtyping import Float

from exoid.mismatch.screen.hypothesis import Optimum
from exoid.mismatch.screen.many_free import by_stretches
from exoid.mismatch.screen.optimise import bounded
from exoid.mismatch.search.found import Found, size

DRAWS = 200
FEWEST = 3  # segments, of which fewer make no sample
STRETCHES = 4  # of a segment, where there are so few
COMPARED = 4  # explanations a side, the best ones, that are simulated once more for that

Parts = Float[np.ndarray, "part column column"]


def inclusion(found: Found, same: list[Optimum], rivals: list[Optimum], seed: int) -> float:
    """The share of bootstrapped sets of segments in which one of the `same` has the most evidence.

    Each candidate is refitted to every set by its quadratic model. Where there are fewer than three
    segments, stretches of time are drawn in their place.
    """
    sides = [sorted(each, key=found.evidence, reverse=True) for each in (same, rivals)]
    if found.prepared.segments < FEWEST:
        sides = [each[:COMPARED] for each in sides]
    parts = [[parts_of(found, one) for one in each] for each in sides]
    count = len(parts[0][0])
    draws = np.random.default_rng(seed).multinomial(count, np.ones(count) / count, DRAWS)
    best = [
        np.max([worths(found, *one, draws) for one in zip(*side, strict=True)], axis=0)
        for side in zip(sides, parts, strict=True)
    ]
    return float(np.mean(best[0] >= best[1]))


def parts_of(found: Found, one: Optimum) -> Parts:
    """Its products of everything that may be drawn."""
    if found.prepared.segments < FEWEST:
        return by_stretches(found.prepared, one.candidate, STRETCHES)
    return one.products.each


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
