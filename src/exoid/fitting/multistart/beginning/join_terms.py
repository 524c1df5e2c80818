"""Terms join starts that Eq. 9 alone has led to the data."""

from collections import Counter
from dataclasses import replace

import jax
import numpy as np

from exoid.fitting.model.coordinates import Coordinates
from exoid.fitting.multistart.beginning.simpler_problems import as_declared, with_terms_kept
from exoid.fitting.multistart.beginning.tethers import COARSE, FINE, led
from exoid.fitting.solve.ask import advance, finite, take, task
from exoid.fitting.solve.problem import Problem
from exoid.fitting.solve.program_values import Solved

NEARBY = 100.0  # tolerance, in units of noise, of a leg on its way to terms that change after it
BEATEN = 2.0  # times the best loss, after one bout of the solver
MISSED = 1.5  # times the noise, beyond which legs are led on with their terms
BEHIND = "with its terms it was far behind the best after one bout of the solver"


def join_terms(
    problem: Problem, gathered: Coordinates, member: np.ndarray, failures: dict[str, int]
) -> tuple[Solved, np.ndarray, dict[str, int]]:
    """Where starts end freely; each start's end; why some were lost.

    Leg and terms run free at once, and again after the leg, its recordings as declared, has found
    its way to the terms as they begin: what both are far from may pass for a frame that rings.
    Where none comes near the noise, they do also after both were led along the measured motion: a
    leg that sticks is stopped too soon by what Eq. 9 took for damping, in a valley of its own. What
    one bout of the solver shows to be beaten is lost.
    """
    fine = task(problem, 0.0, problem.steps, FINE)
    if not problem.terms:
        return advance(problem, gathered, fine), member, failures
    bout = task(problem, 0.0, problem.steps, COARSE, rounds=1)
    towards = replace(bout, tolerance=np.asarray(NEARBY))
    towards_terms = advance(with_terms_kept(as_declared(problem)), gathered, towards).coordinates
    tried = advance(problem, joined(gathered, towards_terms), bout)
    if 2 * finite(tried.loss).min() > MISSED**2 * problem.samples.sum():
        tied = led(as_declared(problem), gathered, rounds=1)
        tried = joined(tried, advance(problem, tied, bout))
    kept = np.flatnonzero(finite(tried.loss) <= BEATEN * finite(tried.loss).min())
    free = advance(problem, take(tried.coordinates, kept), fine)
    loss = np.full((tried.loss.size // gathered.log_mass.size, gathered.log_mass.size), np.inf)
    loss.flat[kept] = finite(free.loss)
    end = np.full(loss.size, -1)
    end[kept] = np.arange(kept.size)
    better = end.reshape(loss.shape)[np.argmin(loss, axis=0), np.arange(loss.shape[1])]
    rows = np.unique(better[better >= 0])  # of its ends, a start has the best one
    better = np.where(better < 0, -1, np.searchsorted(rows, better))
    found = np.append(better, -1)[member]
    behind = {BEHIND: int(((member >= 0) & (found < 0)).sum())}
    return take(free, rows), found, dict(Counter(failures) + Counter(behind))


def joined(*each):
    """Starts or ends one after the other."""
    return jax.tree.map(lambda *leaves: np.concatenate(leaves), *each)
