"""What moves a fit, though it is no unknown of it."""

import numpy as np

from exoid.fitting.misfit.uncertainty import Information
from exoid.fitting.multistart.search_result import SearchResult
from exoid.fitting.result.estimates.moved import Moved
from exoid.fitting.result.systematics.torque_zero import moved_by_torque_zero
from exoid.fitting.solve.problem import Problem


def moved(problem: Problem, ended: SearchResult, information: Information) -> Moved:
    """By the zero of a torque's sensor, and by a law that a leg follows otherwise than a term."""
    return Moved(
        {
            "torque_zero": moved_by_torque_zero(problem, ended),
            "reflex_form": moved_by_law(problem, ended, information),
        }
    )


def moved_by_law(problem: Problem, ended: SearchResult, information: Information) -> np.ndarray:
    """How far it moves, (coordinate, quantity), with each quantity of which a term says so."""
    off = {name: size for term in problem.terms for name, size in term.law_of.items()}
    names = [name for name in off if name in problem.quantities]
    rows = ended.local.quantities[[problem.quantities.index(name) for name in names]]
    return moved_with(rows, np.array([off[name] for name in names]), information)


def moved_with(rows: np.ndarray, sizes: np.ndarray, information: Information) -> np.ndarray:
    """How far x moves where a quantity a'x, a row of `rows`, is off by s: C a s / a'C a, C being
    the covariance of x.
    """
    root = information.root
    if root is None:
        return np.zeros((rows.shape[1], 0))
    along = rows @ root
    told = np.sum(along**2, axis=1)
    share = np.divide(sizes, told, out=np.zeros_like(sizes), where=told > 0)
    return root @ along.T * share
