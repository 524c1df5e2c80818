"""The reference method: SciPy's SLSQP on the same objective, over the raw parameters of Eq. 13."""

from collections import Counter
from dataclasses import replace

import jax
import numpy as np
from scipy.optimize import OptimizeResult, approx_fprime, minimize

from exoid.fitting.misfit.neighbourhood import weighed
from exoid.fitting.model.coordinates import Coordinates
from exoid.fitting.multistart.hold_to_declared import held, less_told
from exoid.fitting.multistart.search_result import FEASIBLE, SearchResult
from exoid.fitting.multistart.weight_by_kind import explained
from exoid.fitting.reference.objective import Objective
from exoid.fitting.solve.ask import advance, around, finite, task
from exoid.fitting.solve.problem import Problem
from exoid.fitting.solve.program_values import Solved
from exoid.physics.term import Term

PRECISION = 1e-7  # change of half a sum of squares in units of noise that ends a search
ITERATIONS = 300
RESTARTS = 30
GAIN = 1e-5  # of a restart, in the same unit, that is none
NOTHING_MOVES = np.inf  # tolerance of a solver that is to look at a point, not to leave it


def search_slsqp(
    problem: Problem, starts: np.ndarray, terms: tuple[Term, ...] = ()
) -> SearchResult:
    """SLSQP with finite differences from every start (m, J, l, d, c, tau) with its terms, one after
    the other.

    Every start is brought to data, prior and limits at once. The best of them without prior and
    limits tells how far the residual exceeds the noise, and is then brought to both under it.

    **Raises** `ValueError` where recordings own more than their starts and torques.
    """
    several = len({each.recording for each in problem.movements}) > 1
    if several or any(each.unplaced for each in problem.movements):
        raise ValueError(
            "slsqp, the reference, fits one recording whose added mass sits at a known distance. "
            "Leave the method out, or fit one recording."
        )
    objective = Objective(problem, 1.0, True)
    own = np.stack([*jax.tree.leaves(terms), *starts.T])[: len(jax.tree.leaves(terms))].T
    begin = [objective.vector(*each) for each in zip(starts, own, strict=True)]
    found = [descend(objective, vector) for vector in begin]
    arrived = np.array([each.success for each in found])
    if not arrived.any():
        raise ArithmeticError(f"no start of SLSQP succeeded: {found[0].message}.")
    cost = finite(np.where(arrived, [each.fun for each in found], np.inf))
    nearest = found[int(np.argmin(cost))].x
    alone = descend(replace(objective, bounded=False), nearest)
    free = look(problem, [objective.point(alone.x)])
    disturbance = explained(problem, free)
    less = less_told(problem, free, 0, disturbance)
    tight = held(problem, less, disturbance, disturbance.scale)
    chosen = descend(replace(objective, problem=tight, scale=disturbance.scale), nearest)
    point = objective.point(chosen.x)
    best = under_limits(tight, point, disturbance.scale, chosen.multipliers)
    return SearchResult(
        free=look(problem, [objective.point(each.x) for each in found]),
        member=np.where(arrived, np.arange(arrived.size), -1),
        failures=dict(Counter(each.message for each in found if not each.success)),
        best=best,
        disturbance=disturbance,
        starts=stacked([objective.point(vector) for vector in begin]),
        local=around(problem, best, disturbance),
    )


def descend(objective: Objective, start: np.ndarray) -> OptimizeResult:
    """SLSQP until starting it again, with all directions scaled to curve alike, gains nothing.

    Typical sizes alone leave the cost curved a million times more along what motion fixes than
    along what only the prior does, and there SLSQP stops early.
    """
    result = once(objective, start, objective.axes / np.sqrt(objective.problem.samples.sum()))
    for _ in range(RESTARTS):
        before = result.fun
        if not np.isfinite(before):
            result.success, result.message = False, "the motion could not be simulated"
            return result
        result = once(objective, result.x, evenly_curved(objective, result.x))
        if before - result.fun < GAIN:
            result.success = bool(objective.slack(result.x).min() > -FEASIBLE)
            return result
    result.success, result.message = False, "SLSQP still gained when its restarts ran out"
    return result


def once(objective: Objective, start: np.ndarray, axes: np.ndarray) -> OptimizeResult:
    """SLSQP over steps along `axes`, with SciPy's finite differences; `x` is the end point."""

    def at(steps: np.ndarray) -> np.ndarray:
        return start + axes @ steps

    result = minimize(
        lambda steps: objective.cost(at(steps)),
        np.zeros(axes.shape[1]),
        method="SLSQP",
        constraints={"type": "ineq", "fun": lambda steps: objective.slack(at(steps))},
        options={"ftol": PRECISION, "maxiter": ITERATIONS},
    )
    result.x = at(result.x)
    return result


def evenly_curved(objective: Objective, vector: np.ndarray) -> np.ndarray:
    """Axes along which a step changes the cost by about one, at most of the typical size."""
    problem = objective.problem
    there = look(problem, [objective.point(vector)])
    local = weighed(around(problem, there), objective.scale)
    by_vector = np.asarray(approx_fprime(vector, objective.flat)) @ objective.axes
    belief = local.declared + objective.bounded * (local.prior - local.declared)
    information = by_vector.T @ (local.data + belief) @ by_vector
    values, vectors = np.linalg.eigh(information)
    return objective.axes @ vectors / np.sqrt(np.maximum(values, 0) + 1)


def look(
    problem: Problem,
    points: list[Coordinates],
    scale: float = 1.0,
    penalty: np.ndarray | None = None,
) -> Solved:
    """The compiled program at these points, told that every step is negligible."""
    still = task(problem, 0.0, problem.steps, NOTHING_MOVES, penalty)
    return advance(problem, stacked(points), still, scale)


def under_limits(
    problem: Problem, point: Coordinates, scale: float, multipliers: np.ndarray
) -> Solved:
    """This point as a bounded fit gives it back, with SLSQP's own multipliers of the limits."""
    limits = multipliers[:-2]  # without those that keep mass and inertia positive
    seen = look(problem, [point], scale, np.ones(limits.size))
    return replace(seen, multiplier=limits[None])


def stacked(points: list[Coordinates]) -> Coordinates:
    return jax.tree.map(lambda *each: np.stack(each), *points)
