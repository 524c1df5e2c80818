"""What a model misses also leads a fit astray that is held to what is declared.

A fit by least squares sees white noise, and is held to a level seat and a known zero. Where
something is missing, the residual r = A dz + S u + e has the covariance V = s^2 I + S K S', and
weighed by that, with slope g and curvature P of what is believed, the data ask for another step:

    dz = -(A'V^-1 A + P)^-1 (A'V^-1 r + g).
"""

import numpy as np

from exoid.fitting.misfit.gram import Gram
from exoid.fitting.misfit.gram_matrices import covariance
from exoid.fitting.misfit.missed import Missed
from exoid.fitting.misfit.neighbourhood import declared_slopes
from exoid.fitting.misfit.uncertainty import VAGUE
from exoid.fitting.model.prior import mounting_residual
from exoid.fitting.multistart.search_result import SearchResult
from exoid.fitting.solve.ask import grams_at
from exoid.fitting.solve.problem import Problem


def led_astray(problem: Problem, ended: SearchResult) -> dict[str, float]:
    """How far every quantity may be led astray: by that step, and where a seat that nobody declared
    so is taken for tilted, by how far off the leg is on a level one.
    """
    each = [steps(problem, ended)] if ended.disturbance.cause is not None else []
    if ended.level is not None:
        each.append(ended.best.quantities[0] - ended.level)
    far = np.linalg.norm(each, axis=0) if each else np.zeros(len(problem.quantities))
    return dict(zip(problem.quantities, far, strict=True))


def steps(problem: Problem, ended: SearchResult) -> np.ndarray:
    """How far that step takes every quantity."""
    found, local, prior = ended.disturbance, ended.local, problem.belief.prior
    causes = found.causes(problem.kinds)
    every = grams_at(problem, ended.best, 0, set(causes))
    curvature = local.prior + VAGUE * np.eye(len(local.prior))
    declared = mounting_residual(prior, ended.point.mounting, np)
    slope = declared_slopes(ended.point, prior).T @ declared
    for own, cause, kind in zip(every, causes, problem.kinds, strict=True):
        gram = own[cause]
        known = weighed(gram, found.kinds[kind])
        curvature[np.ix_(gram.place, gram.place)] += known[:-1, :-1]
        slope[gram.place] += known[:-1, -1]
    return local.quantities @ np.linalg.solve(curvature, slope)


def weighed(gram: Gram, missed: Missed) -> np.ndarray:
    """(A, r)'V^-1 (A, r) of a segment."""
    process = covariance(gram, missed.correlation_time)
    spread = np.eye(len(gram.effect)) + missed.ratio * gram.effect @ process @ gram.effect.T
    inside = gram.inside.T @ np.linalg.solve(spread, gram.inside)
    return (inside + gram.outside.T @ gram.outside) / missed.noise**2
