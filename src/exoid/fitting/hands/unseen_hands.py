"""A hand on the leg that only a fit can see."""

from collections.abc import Callable

from exoid.fitting.data.movement import Movement
from exoid.fitting.hands.first_instants import differ, disturbed, doubtful, without_first_instants
from exoid.fitting.hands.last_instants import without_hands
from exoid.fitting.multistart.search_result import SearchResult
from exoid.fitting.solve.problem import Problem

FEW = 4  # starts, where it is only asked whether more than noise is left


def without_unseen_hands(
    problem: Problem,
    ended: SearchResult,
    search_of: Callable[[list[Movement], int], tuple[Problem, SearchResult]],
    starts: int,
    *,
    at_once: bool,
) -> tuple[Problem, SearchResult]:
    """The search again without the begins and ends of movements, where they alone do not fit.

    `search_of` takes movements and a number of starts.
    """
    movements = problem.movements
    rest = movements if at_once else without_first_instants(movements)
    if any(each.late for each in rest) and doubtful(problem, ended):
        later = search_of(rest, starts)
        if differ(movements, ended, rest, later[1]):
            problem, ended = later
    if not problem.belief.rig and disturbed(ended):
        freed = without_hands(problem, ended, lambda kept: search_of(kept, FEW))
        if freed is not None:
            problem, ended = search_of(freed, starts)
    return problem, ended
