"""A hand on the leg that only a fit can see."""

from collections.abc import Callable

from exoid.fitting.data.movement import Movement
from exoid.fitting.hands.first_instants import (
    beyond_noise,
    differ,
    disturbed,
    doubtful,
    without_first_instants,
)
from exoid.fitting.hands.last_instants import without_hands
from exoid.fitting.multistart.search_result import Plain, SearchResult
from exoid.fitting.solve.problem import Problem

FEW = 4  # starts, where it is only asked whether more than noise is left
Glance = Callable[[list[Movement], Plain], tuple[Problem, SearchResult]]


def without_unseen_hands(
    problem: Problem,
    ended: SearchResult,
    search_of: Callable[[list[Movement]], tuple[Problem, SearchResult]],
    glance_at: Glance,
    *,
    at_once: bool,
) -> tuple[Problem, SearchResult]:
    """The search again without the begins and ends of movements, where they alone do not fit.

    `glance_at` takes movements, and what tells by what is missed whether the answer is plain.
    """
    movements = problem.movements
    rest = movements if at_once else without_first_instants(movements)
    if any(each.late for each in rest) and doubtful(problem, ended):
        later = search_of(rest)
        if differ(movements, ended, rest, later[1]):
            problem, ended = later
    if not problem.belief.rig and disturbed(ended):
        freed = without_hands(problem, ended, lambda kept: glance_at(kept, beyond_noise))
        if freed is not None:
            problem, ended = search_of(freed)
    return problem, ended
