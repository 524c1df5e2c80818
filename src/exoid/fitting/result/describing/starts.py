"""How many starts arrived where."""

import numpy as np

from exoid.fitting.multistart.search_result import SAME_LOSS, SearchResult
from exoid.fitting.result.equally_good import equally_good
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.fit_result import MultistartReport
from exoid.fitting.solve.ask import finite
from exoid.fitting.solve.problem import Problem

UNFINISHED = "it was still moving when its steps ran out"


def report(problem: Problem, ended: SearchResult, ratios: dict[str, Estimate]) -> MultistartReport:
    """How many starts arrived where, and the sets that fit as well as the chosen one.

    Who ran out of steps short of the best cost found no minimum, and did not succeed.
    """
    reached = ended.member >= 0
    free = finite(ended.free.loss)
    least = free[ended.member[reached]].min() * (1 + SAME_LOSS)
    moving = np.asarray(ended.free.exhausted) & (free > least)
    tired = reached & moving[ended.member]
    loss = np.where(reached, free[ended.member], np.inf)
    at_best = loss <= least
    family, members = equally_good(problem, ended, np.flatnonzero(at_best), ratios)
    minima = free[np.isfinite(free) & ~moving]
    return MultistartReport(
        starts=ended.member.size,
        succeeded=int((reached & ~tired).sum()),
        at_best=int(at_best.sum()),
        loss=loss,
        failures=ended.failures | ({UNFINISHED: int(tired.sum())} if tired.any() else {}),
        family=family,
        members=members,
        distinct=len(np.unique(np.round(np.log(minima), 3))),
    )
