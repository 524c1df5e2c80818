"""What is known around the best fit, and what holds it there."""

import numpy as np

from exoid.fitting.misfit.neighbourhood import columns, told
from exoid.fitting.misfit.uncertainty import Information, Pressed, decomposed, inverse_times
from exoid.fitting.model.constraint import NEVER, violations_at
from exoid.fitting.model.coordinates import layout, places
from exoid.fitting.multistart.search_result import SearchResult
from exoid.fitting.result.estimates.owned import FIELDS
from exoid.fitting.solve.ask import around, take
from exoid.fitting.solve.problem import Problem

# Of half a chi-square for a typical step of what is limited: where nothing tells a value, a search
# may end on a limit that does not hold it back.
PRESSING = 1e-3


def leans(problem: Problem, ended: SearchResult) -> np.ndarray:
    """Which constraints hold the best fit back; what was fixed by hand is none of them."""
    by_hand = [name in problem.belief.by_hand.fix for name in problem.constraints]
    return (ended.best.multiplier[0] > PRESSING) & ~np.array(by_hand)


def information_at(problem: Problem, ended: SearchResult, leaning: np.ndarray) -> Information:
    """What is known around the best fit, and what holds it."""
    local, names = ended.local, problem.constraints
    by_hand = problem.belief.by_hand.fix
    # Both ends of a range that is a value are one constraint.
    fixed = np.array([name in by_hand and name not in names[:at] for at, name in enumerate(names)])
    return Information(
        data=local.data + local.declared,
        prior=local.prior - local.declared,
        active=local.constraints[fixed],
        pressed=pressed_at(problem, ended, np.flatnonzero(leaning)),
        fixed=local.constraints[fixed],
        kinds=told_by_kind(problem, ended),
        owned=owned_places(problem, ended),
    )


def pressed_at(problem: Problem, ended: SearchResult, rows: np.ndarray) -> Pressed:
    """Limits that hold the best fit: how far beyond them it would be, by what it minimised."""
    best, gradients, names = ended.best, ended.local.constraints[rows], problem.constraints
    if not rows.size:
        return Pressed(gradients, np.zeros(0), np.zeros(0))
    searched = around(problem, best)
    known = decomposed(searched.data + searched.prior)
    variance = np.array([each @ inverse_times(known, each) for each in gradients])
    values = violations_at(problem.belief.limits, ended.point, np)

    def room(row: int) -> float:
        ends = [k for k, name in enumerate(names) if name == names[row] and k != row]
        return min((-values[k] for k in ends if values[k] != NEVER), default=np.inf)

    beyond = best.multiplier[0, rows] * variance
    return Pressed(gradients, beyond, np.array([room(row) for row in rows.tolist()]))


def owned_places(problem: Problem, ended: SearchResult) -> dict[str, np.ndarray]:
    """The coordinates of everything that recordings own, by its name."""
    numbers = places(ended.point).mounting
    free = {name: getattr(numbers, name)[problem.estimated(name)] for name in problem.owned}
    return {FIELDS[name]: at for name, at in free.items() if at.size}


def told_by_kind(problem: Problem, ended: SearchResult) -> dict[str, np.ndarray]:
    """The weighed information of every kind of segment, where there are several."""
    kinds, found = dict.fromkeys(problem.kinds), {}
    if len(kinds) < 2:
        return found
    place, size = columns(ended.point, problem.observation.owner), layout(ended.point).size
    for kind in kinds:
        own = np.array([each == kind for each in problem.kinds])
        condensed = take(take(ended.best.condensed, 0), own)
        found[kind] = told(condensed, place[own], size)
    return found
