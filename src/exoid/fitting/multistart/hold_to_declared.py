"""What a model misses is not to be made up for by what recordings own.

A fit by least squares sees white noise only. Where something is missing, zero, seat or clock would
leave what is declared of them, to explain what they did not do: their misfit is less sure than it
looks. Each is therefore held to what is declared by as much more as the data tell less of it.
"""

from dataclasses import replace

import jax
import numpy as np

from exoid.fitting.misfit.missed import Disturbance
from exoid.fitting.misfit.neighbourhood import prior_information
from exoid.fitting.model.coordinates import TYPICAL, places
from exoid.fitting.model.systematics import OF_THE_LOAD, OWNED
from exoid.fitting.multistart.beginning.simpler_problems import with_inertia_kept
from exoid.fitting.multistart.beginning.tethers import FINE
from exoid.fitting.multistart.search_result import scale_told
from exoid.fitting.multistart.weight_by_kind import (
    as_weighed,
    by_themselves,
    explained,
    explained_apart,
)
from exoid.fitting.solve.ask import advance, better_of, lowest, take, task, told_at
from exoid.fitting.solve.problem import Problem
from exoid.fitting.solve.program_values import Solved

EXCUSED = 1.3  # widening of an error below which holding it to what is declared changes little
ROUNDS = 3  # of holding it, each by what the one before made of the residual
ROUNDING = 1e-9  # relative, of a precision
KEPT = ("torque_gain", *OF_THE_LOAD)
NOTHING = 1e-6  # of what is declared, that is told: below it white noise tells nothing either

Less = dict[str, np.ndarray]  # of every leaf of the mounting: how much wider, at least 1


def without_excuses(
    problem: Problem, free: Solved, found: Disturbance
) -> tuple[Solved, Disturbance, Less]:
    """All free fits, recordings held to what is declared by as much more as they tell less.

    They also begin as declared: over kinks of dry friction a search does not find back to it. An
    inertia that nothing tells stays where it is.
    """
    row = lowest(free)
    less = less_told(problem, free, row, found)
    if worst(less) < EXCUSED:
        return free, found, less
    asked = task(problem, 0.0, problem.steps, FINE)
    told = scale_told(told_at(problem, free, row))
    moved = problem if told else with_inertia_kept(problem)
    for _ in range(ROUNDS):
        tight, weighing = held(moved, less, found), found.weighing(problem.kinds)
        declared = jax.tree.map(np.zeros_like, free.coordinates.mounting)
        begin = (free.coordinates, replace(free.coordinates, mounting=declared))
        starts = jax.tree.map(lambda *each: np.concatenate(each), *begin)
        ended, count = advance(tight, starts, asked, weighing), free.loss.size
        free = better_of(take(ended, np.arange(count)), take(ended, np.arange(count, 2 * count)))
        before, row = less, lowest(free)
        alike = explained(problem, free, row)
        found = explained_apart(problem, by_themselves(problem, free, row, alike), alike)
        less = less_told(problem, free, row, found)
        if worst(less) < EXCUSED * worst(before):
            break
    return free, found, less


def worst(less: Less) -> float:
    """The greatest of them."""
    return max((each.max() for each in less.values() if each.size), default=1.0)


def less_told(problem: Problem, at: Solved, row: int, found: Disturbance) -> Less:
    """By how much the errors of what recordings own are wider than white noise makes them.

    Each as all but its own declaration tells it.
    """
    point, white = take(at.coordinates, row), told_at(problem, at, row)
    prior, numbers = prior_information(point, problem.belief.prior), places(point).mounting
    precisions = [precision(each + prior) for each in (white, found.information)]

    def of(name: str) -> np.ndarray:
        own = (getattr(TYPICAL.mounting, name) / problem.deviation_of(name)) ** 2
        entries = getattr(numbers, name)
        white, true = (np.maximum(each[entries] - own, 0.0) for each in precisions)
        return np.sqrt(np.maximum(white / (true + NOTHING * own), 1.0))

    return {name: of(name) for name in OWNED}


def precision(information: np.ndarray) -> np.ndarray:
    """Of every coordinate, the others unknown."""
    diagonal = np.diag(information)
    return 1 / np.diag(np.linalg.inv(information + ROUNDING * np.diag(1 + diagonal)))


def held(problem: Problem, less: Less, found: Disturbance, scale: float = 1.0) -> Problem:
    """The problem in which they are held so, where residuals count 1 / `scale`, and those of every
    kind as what was `found` weighs them.

    The gain of a torque keeps its own: no residual tells it, and against what anatomy expects of J
    it is as sure as it is declared.
    """
    weighed = as_weighed(problem, found)
    wider = {name: weighed.deviation_of(name) * scale / less[name] for name in OWNED}
    kept = {name: problem.deviation_of(name) for name in KEPT}
    return problem.widened(**wider | kept)
