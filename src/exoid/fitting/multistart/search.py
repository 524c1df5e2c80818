"""The fit: many starts, brought to the data first, then to what anatomy and bounds allow."""

from dataclasses import replace

import jax
import numpy as np

from exoid.fitting.misfit.missed import Disturbance
from exoid.fitting.model.coordinates import Coordinates
from exoid.fitting.multistart.beginning.join_terms import join_terms
from exoid.fitting.multistart.beginning.led_to_data import led_to_the_data
from exoid.fitting.multistart.beginning.simpler_problems import without_scale
from exoid.fitting.multistart.beginning.starts import coordinates
from exoid.fitting.multistart.beginning.tethers import FINE, tethers, within_reach
from exoid.fitting.multistart.by_angle import missed_by_angle
from exoid.fitting.multistart.doubted_clocks import (
    doubted,
    not_by_anatomy,
    with_doubted_clocks,
)
from exoid.fitting.multistart.hold_to_declared import held, without_excuses
from exoid.fitting.multistart.search_result import Plain, SearchResult
from exoid.fitting.multistart.settle import settle
from exoid.fitting.multistart.tilted_seats import with_tilted_seats
from exoid.fitting.multistart.weight_by_kind import (
    as_weighed,
    by_themselves,
    explained,
    explained_apart,
    kinds_of,
)
from exoid.fitting.solve.ask import advance, around, left, lowest, take, task
from exoid.fitting.solve.problem import Problem
from exoid.fitting.solve.program_values import Solved
from exoid.physics.term import Term

FAR = 2.0  # times the noise, root mean square: of a hundred samples a chi-square of three hundred


def never(found: Disturbance) -> bool:
    """Where all numbers are wanted, no answer is plain."""
    return False


def search(
    problem: Problem,
    starts: np.ndarray,
    terms: tuple[Term, ...] = (),
    *,
    near: bool = False,
    plain: Plain = never,
) -> tuple[Problem, SearchResult]:
    """Fit from every start (m, J, l, d, c, tau) with its terms.

    Starts are led to the measured motion, then run free; where the first is `near` the end, it does
    at once, and the others are other masses and inertias at its ratios. The best free fit meets
    prior and limits. Also the problem, its priors wider where a seat or a clock is unusual
    (`rare.py`).

    Who only asks whether noise is all that is left has an answer that is `plain` by what the free
    fits miss: held closer to anything, they miss more. The best of them then stays as it ended.
    """
    begin = coordinates(starts, problem.movements, terms, problem.owned)
    begin = within_reach(begin, tethers(problem)[0], problem.longest_step)
    if near:
        gathered, member, failures = take(begin, [0]), np.zeros(len(starts), dtype=int), {}
    else:
        gathered, member, failures = led_to_the_data(problem, begin, terms)
    free, member, failures = join_terms(without_scale(problem), gathered, member, failures)
    member, failures = without_lost(free, member, failures)
    ends, found = compared(problem, free)
    if plain(found) and misses_by_far(problem, free, found):
        return problem, as_it_ended(problem, free, found, (member, failures, begin))
    level, seen = problem, weighed(problem, free, ends, found)
    problem, free, disturbance = with_what_is_missed(problem, *seen)
    if plain(disturbance):
        return problem, as_it_ended(problem, free, disturbance, (member, failures, begin))
    on_level = None if problem is level else on_level_seats(level, *seen)
    free, disturbance, less = without_excuses(problem, free, disturbance)
    tight = held(problem, less, disturbance, disturbance.scale)
    best = settle(tight, free, begin, disturbance)
    if problem.belief.by_hand.fix or problem.belief.by_hand.bound:
        disturbance = explained(problem, best)  # what no free leg would leave, but this one does
        tight = held(problem, less, disturbance, disturbance.scale)
        best = settle(tight, free, begin, disturbance)
    local = around(problem, best, disturbance)
    wide = with_doubted_clocks(problem, best, local)
    if wide is not None:  # the suspicion widens errors, and moves no value
        clocks = doubted(problem, wide, best)
        problem, local = wide, not_by_anatomy(around(wide, best, disturbance), clocks)
    ended = SearchResult(
        free, member, failures, best, disturbance, begin, local, on_level, tight.belief.prior
    )
    return problem, replace(ended, by_angle=missed_by_angle(problem, best, disturbance))


def as_it_ended(
    problem: Problem,
    free: Solved,
    found: Disturbance,
    starts: tuple[np.ndarray, dict[str, int], Coordinates],
) -> SearchResult:
    """The best of the free fits as the chosen one. Of `starts` the free fit of each, why some were
    lost, and where they began.
    """
    (member, failures, begin), best = starts, take(free, [lowest(free)])
    return SearchResult(free, member, failures, best, found, begin, around(problem, best))


def with_what_is_missed(
    problem: Problem, free: Solved, found: Disturbance
) -> tuple[Problem, Solved, Disturbance]:
    """The free fits, weighed by what was `found`, on seats that are tilted if need be.

    Where kinds miss different things, the one that is weighed most tells of the seat.
    """
    if found.apart and found.kinds[found.trusted].cause is None:
        return problem, free, found
    wide, tilted = with_tilted_seats(problem, free, lowest(free), found)
    if wide is problem:
        return problem, free, found
    return wide, *weighed(wide, tilted, *compared(wide, tilted))


def on_level_seats(problem: Problem, free: Solved, found: Disturbance) -> np.ndarray:
    """Every quantity of the best of these free fits, on seats that are as level as is declared."""
    level = without_excuses(problem, free, found)[0]
    return level.quantities[lowest(level)]


def compared(problem: Problem, free: Solved) -> tuple[Solved | None, Disturbance]:
    """Where every kind of segments ends by itself, as far as that was asked, and what each misses
    where that differs from what is alike in all.
    """
    row = lowest(free)
    alike = explained(problem, free, row)
    ends = by_themselves(problem, free, row, alike)
    return ends, explained_apart(problem, ends, alike)


def misses_by_far(problem: Problem, free: Solved, found: Disturbance) -> bool:
    """Is so much missed that no wider prior of a seat explains it? One that would be moved by k
    standard deviations gains k^2 / 8 of half a chi-square at most.
    """
    if found.apart:
        return found.alone[found.trusted] > FAR
    return bool(free.misfit[lowest(free)] > FAR**2 * problem.samples.sum())


def weighed(
    problem: Problem, free: Solved, ends: Solved | None, found: Disturbance
) -> tuple[Solved, Disturbance]:
    """The free fits by what was `found` of every kind of segments, and that; all of them once more
    where kinds miss different things.

    The best of them begins anew where the kind that is weighed most `ends` by itself: that may be
    far from where all were weighed alike.
    """
    if ends is None or not found.apart:
        return free, found
    row = lowest(free)
    trusted = take(ends.coordinates, kinds_of(problem).index(found.trusted))
    starts = replaced(free.coordinates, row, trusted)
    asked = task(problem, 0.0, problem.steps, FINE)
    again = advance(as_weighed(problem, found), starts, asked, found.weighing(problem.kinds))
    return again, left(problem, again, lowest(again), found)


def replaced(tree, row: int, new):
    """The same with `new` in this row of every leaf."""
    rows = jax.tree.map(np.array, tree)
    jax.tree.map(lambda leaf, one: leaf.__setitem__(row, one), rows, new)
    return rows


def without_lost(free: Solved, member: np.ndarray, failures: dict[str, int]):
    """Mark the starts whose free fit was lost."""
    lost = ~np.isfinite(free.loss)
    gone = (member >= 0) & lost[member]
    failures = dict(failures)
    if gone.any():
        failures["its free motion could not be simulated"] = int(gone.sum())
    if lost.all():
        raise ArithmeticError("no start reached a motion that can be simulated freely.")
    return np.where(gone, -1, member), failures
