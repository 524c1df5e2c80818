"""Would the same cause be found had other segments been recorded?"""

import numpy as np

from exoid.mismatch.evidence.yardstick import Yardstick
from exoid.mismatch.screen.optimise import bounded
from exoid.mismatch.screen.optimum import Optimum
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.mismatch.search.found import size

DRAWS = 200
FEWEST = 3  # segments, of which fewer make no sample


def inclusion(
    prepared: PreparedRecording, best: Optimum, rivals: list[Optimum], measure: Yardstick, seed: int
) -> float | None:
    """The share of bootstrapped sets of segments in which `best` has the most evidence.

    Each candidate is refitted to every set by its quadratic model. None where there are too few
    segments.
    """
    if prepared.segments < FEWEST:
        return None
    rng = np.random.default_rng(seed)
    draws = rng.multinomial(
        prepared.segments, np.ones(prepared.segments) / prepared.segments, DRAWS
    )
    worths = np.array([[worth(prepared, one, draw, measure) for draw in draws] for one in rivals])
    own = np.array([worth(prepared, best, draw, measure) for draw in draws])
    return float(np.mean(own >= worths.max(axis=0, initial=-np.inf)))


def worth(prepared: PreparedRecording, one: Optimum, draw: np.ndarray, measure: Yardstick) -> float:
    """Minus what a candidate leaves of a set of segments, and minus its price."""
    total = np.tensordot(draw, one.products.each, axes=1)
    normal, gradient, square = total[:-1, :-1], total[:-1, -1], total[-1, -1]
    at = one.candidate.unknowns
    lower, upper = prepared.bounds(one.candidate)
    change = bounded(normal, gradient, 0.0, lower - at, upper - at)
    left = square + 2 * gradient @ change + change @ normal @ change
    return -float(left) / measure.scale - measure.price(size(one))
