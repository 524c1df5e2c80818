"""How far a fit may have moved by what is no unknown of it, and its numbers with it."""

from dataclasses import dataclass

import numpy as np

from exoid.fitting.misfit.uncertainty import Information
from exoid.fitting.multistart.search_result import SearchResult
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.estimates.torque_zero import moved_by_torque_zero
from exoid.fitting.solve.problem import Problem


@dataclass(frozen=True, eq=False)
class Moved:
    """Steps of the coordinates, (coordinate, step) by cause, each of one standard deviation."""

    by: dict[str, np.ndarray]

    def widen(self, each: Estimate, gradient: np.ndarray) -> Estimate:
        """An estimate of this gradient, its error with how far it may be off."""
        for cause, steps in self.by.items():
            each = each.widened(float(np.linalg.norm(gradient @ steps)), cause=cause)
        return each

    def off(self, gradient: np.ndarray) -> float:
        """How far a quantity of this gradient may be off."""
        return float(np.linalg.norm([np.linalg.norm(gradient @ each) for each in self.by.values()]))


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
