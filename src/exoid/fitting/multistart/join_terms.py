"""Terms join starts that Eq. 9 alone has led to the data."""

from collections import Counter
from dataclasses import replace

import jax
import numpy as np

from exoid.fitting.model.coordinates import Coordinates
from exoid.fitting.multistart.simpler_problems import as_declared, with_terms_kept
from exoid.fitting.multistart.tethers import COARSE, FINE
from exoid.fitting.solve.ask import advance, finite, take, task
from exoid.fitting.solve.problem import Problem
from exoid.fitting.solve.program_values import Solved

NEARBY = 100.0  # tolerance, in units of noise, of a leg on its way to terms that change after it
BEATEN = 2.0  # times the best loss, after one bout of the solver
BEHIND = "with its terms it was far behind the best after one bout of the solver"


def join_terms(
    problem: Problem, gathered: Coordinates, member: np.ndarray, failures: dict[str, int]
) -> tuple[Solved, np.ndarray, dict[str, int]]:
    """Where starts end freely; each start's end; why some were lost.

    Leg and terms run free at once, and again after the leg, its recordings as declared, has found
    its way to the terms as they begin: what both are far from may pass for a frame that rings. What
    one bout of the solver shows to be beaten is lost.
    """
    fine = task(problem, 0.0, problem.steps, FINE)
    if not problem.terms:
        return advance(problem, gathered, fine), member, failures
    bout = task(problem, 0.0, problem.steps, COARSE, rounds=1)
    towards = replace(bout, tolerance=np.asarray(NEARBY))
    led = advance(with_terms_kept(as_declared(problem)), gathered, towards).coordinates
    both = jax.tree.map(lambda *each: np.concatenate(each), gathered, led)
    tried = advance(problem, both, bout)
    kept = np.flatnonzero(finite(tried.loss) <= BEATEN * finite(tried.loss).min())
    free = advance(problem, take(tried.coordinates, kept), fine)
    loss = np.full((2, gathered.log_mass.size), np.inf)
    loss.flat[kept] = finite(free.loss)
    end = np.full(loss.size, -1)
    end[kept] = np.arange(kept.size)
    better = end.reshape(loss.shape)[np.argmin(loss, axis=0), np.arange(loss.shape[1])]
    rows = np.unique(better[better >= 0])  # of two ends, a start has the better one
    better = np.where(better < 0, -1, np.searchsorted(rows, better))
    found = np.append(better, -1)[member]
    behind = {BEHIND: int(((member >= 0) & (found < 0)).sum())}
    return take(free, rows), found, dict(Counter(failures) + Counter(behind))
