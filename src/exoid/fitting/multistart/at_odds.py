"""How far the parts of a session are at odds about what they tell.

At the end of a fit its parts hold each other: s = H^-1 A'r of all samples is nothing, but of a part
it is how far that part pulls. Where a model misses something, parts do not pull by their noise
alone: a leg with a load in some drops is two legs, and dry friction damps small swings more than
large ones. The variance by n parts that are each wrong in their own way is (Liang and Zeger,
Biometrika 73:13, 1986)

    n / (n - 1) sum (s - mean s)^2,

once over the segments, and once over the two halves in time of all segments: what goes with how
far a leg swings is alike in each, and pulls early and late apart.
"""

import numpy as np

from exoid.fitting.misfit.neighbourhood import columns
from exoid.fitting.misfit.uncertainty import VAGUE
from exoid.fitting.multistart.search_result import SearchResult
from exoid.fitting.solve.ask import sensed
from exoid.fitting.solve.problem import Problem


def at_odds(problem: Problem, ended: SearchResult) -> dict[str, float]:
    """The standard error of every quantity by that; none where nothing is missed."""
    if ended.disturbance.cause is None:
        return {}
    each = pulls(problem, ended)
    variance = scatter(each.sum(axis=1)) + scatter(each.sum(axis=0))
    return dict(zip(problem.quantities, np.sqrt(variance), strict=True))


def pulls(problem: Problem, ended: SearchResult) -> np.ndarray:
    """How far either half of every segment pulls: (segment, half, quantity)."""
    found, local, seen = ended.disturbance, ended.local, sensed(problem, ended.point)
    size = len(local.prior)
    known, slopes = local.prior + VAGUE * np.eye(size), np.zeros((len(problem.kinds), 2, size))
    scales = found.scale * found.weighing(problem.kinds)
    places = columns(ended.point, problem.observation.owner)
    each = zip(places, scales, seen.columns, seen.residual, slopes, strict=True)
    for place, scale, sensitivity, residual, slope in each:
        counted = np.flatnonzero(sensitivity.any(axis=(0, 2)))
        for half, samples in zip(slope, np.array_split(counted, 2), strict=True):
            rows = sensitivity[:, samples].reshape(len(place), -1) / scale
            known[np.ix_(place, place)] += rows @ rows.T
            half[place] = rows @ residual[samples].ravel() / scale
    return slopes @ np.linalg.solve(known, local.quantities.T)


def scatter(parts: np.ndarray) -> np.ndarray:
    """The variance of the sum of these parts (part, quantity); a single one tells none."""
    count = len(parts)
    return count * parts.var(axis=0, ddof=1) if count > 1 else np.zeros(parts.shape[1:])
