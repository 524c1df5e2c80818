"""What a torque that is no part of the model makes of a fit near its end point.

A fit without it errs by H^-1 A'S of that torque over J, with the sensitivities A of the residual r,
S its answer to the torque, and H = A'A and what is believed. The data tell S'S - S'A H^-1 A'S of
the torque, and show S'A H^-1 g - S'r over that: at a minimum the slope g is 0, but where the torque
is hardly told apart, a little of it counts.
"""

from collections.abc import Callable, Sequence

import numpy as np

from exoid.fitting.misfit.gram import Grams
from exoid.fitting.misfit.neighbourhood import prior_information, pull_of_belief
from exoid.fitting.misfit.uncertainty import decomposed, inverse_times
from exoid.fitting.model.coordinates import Coordinates, flattened, layout, unflattened
from exoid.fitting.model.prior import mounting_residual
from exoid.fitting.multistart.search_result import SearchResult
from exoid.fitting.solve.ask import grams_at
from exoid.fitting.solve.problem import Problem

Numbers = Callable[[Coordinates], dict[str, float]]  # of a result, at a point


def grams_of(problem: Problem, ended: SearchResult) -> list[Grams]:
    """The inner products of every segment at the end point, with what torques at nodes do."""
    return grams_at(problem, ended.best, 0, ["torque"])


def answer(
    problem: Problem,
    ended: SearchResult,
    free: np.ndarray,
    grams: Sequence[Grams],
    shapes: Sequence[np.ndarray | float],
) -> tuple[np.ndarray, float, float]:
    """H^-1 A'S for a torque over J that goes through these values at the nodes of every segment
    [rad/s^2]; what the data tell of its size beside the coordinates; and, over that, the size that
    they show. Nothing holds the coordinates in the `free` directions; `grams` are `grams_of`.
    """
    scale = ended.disturbance.scale * ended.disturbance.weighing(problem.kinds)
    prior, point = ended.held or problem.belief.prior, ended.point
    known = ended.local.prior - prior_information(point, problem.belief.prior)
    known += prior_information(point, prior)
    slope, uphill = np.zeros(len(known)), pull_of_belief(point, prior)
    own = seen = 0.0
    for each, unit, shape in zip(grams, scale, shapes, strict=True):
        gram = each["torque"]
        pushed = gram.effect @ np.broadcast_to(shape, gram.nodes.shape) / unit
        fitted = gram.fitted / unit**2
        known[np.ix_(gram.place, gram.place)] += fitted[:-1, :-1]
        uphill[gram.place] += fitted[:-1, -1]
        slope[gram.place] += pushed @ gram.inside[:, :-1] / unit
        own += pushed @ pushed
        seen -= pushed @ gram.inside[:, -1] / unit
    pull = free @ inverse_times(decomposed(free.T @ known @ free), free.T @ slope)
    return pull, float(own - slope @ pull), float(seen + pull @ uphill)


def beyond_noise(problem: Problem, ended: SearchResult) -> float:
    """The squares that a fit misses beyond the noise, and those of what it takes recordings to own
    instead, over what is usual; at least those of one reading.
    """
    owned = mounting_residual(ended.held or problem.belief.prior, ended.point.mounting, np)
    missed = float(ended.best.misfit[0]) - float(problem.samples.sum())
    return max(missed, 0.0) + max(float(owned @ owned), 1.0)


def moved(numbers: Numbers, ended: SearchResult, steps: np.ndarray) -> dict[str, float]:
    """How far every one of a result's `numbers` goes with these steps of the coordinates."""
    here = flattened(ended.point)
    there = unflattened(here + steps * layout(ended.point).units, ended.point)
    before, after = map(numbers, (ended.point, there))
    return {name: after[name] - before[name] for name in before}
