"""The fit: many starts, brought to the data first, then to what anatomy and bounds allow."""

from collections import Counter
from dataclasses import replace

import jax
import numpy as np

from exoid.fitting.data.pace import quickest
from exoid.fitting.misfit.missed import Disturbance
from exoid.fitting.model.coordinates import Coordinates, scaled
from exoid.fitting.model.term_parameters import over_inertia
from exoid.fitting.multistart.gross_errors import (
    doubted,
    not_by_anatomy,
    with_doubted_clocks,
    with_tilted_seats,
)
from exoid.fitting.multistart.hold_to_declared import held, without_excuses
from exoid.fitting.multistart.join_terms import join_terms
from exoid.fitting.multistart.search_result import LOOKING, Plain, SearchResult
from exoid.fitting.multistart.settle import settle
from exoid.fitting.multistart.simpler_problems import (
    as_declared,
    with_zero_free,
    without_scale,
    without_terms,
)
from exoid.fitting.multistart.starts import coordinates, usual_mounting
from exoid.fitting.multistart.tethers import COARSE, FINE, tethers, within_reach, without_thrust
from exoid.fitting.multistart.weight_by_kind import (
    as_weighed,
    by_themselves,
    explained,
    explained_apart,
    kinds_of,
)
from exoid.fitting.solve.ask import advance, around, finite, left, lowest, take, task
from exoid.fitting.solve.problem import Problem
from exoid.fitting.solve.program_values import Solved
from exoid.physics.term import Term

BASIN = 0.2  # typical steps within which tied starts have come together
FAR = 2.0  # times the noise, root mean square: of a hundred samples a chi-square of three hundred
HOPELESS = 1e5  # times the best loss, of a tied start that leads nowhere
FIRST_HORIZON = 1.0  # s of every segment that a start sees first ...
HORIZON = 25.0  # ... or so many radians of what is quicker than a leg


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
    (`gross_errors.py`).

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
    return problem, ended


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


def led_to_the_data(
    problem: Problem, begin: Coordinates, terms: tuple[Term, ...]
) -> tuple[Coordinates, np.ndarray, dict[str, int]]:
    """Starts that have come together, one of each basin; each start's basin; why some were lost.

    Tied to the measured motion over its first second, then over all of it. Each time starts that
    have come together are carried on by the best of them. Ties make up for what Eq. 9 leaves out,
    so terms wait where they begin: starts that have come together go on once with each of these.
    """
    bare = without_terms(problem)
    tether, weaker = tethers(bare)
    seconds = min(FIRST_HORIZON, HORIZON / max(quickest(bare.movements), 1.0))
    first = np.searchsorted(np.asarray(bare.observation.time)[0], seconds)
    horizon = min(max(int(first), 50), bare.steps)
    declared = as_declared(without_scale(bare))
    usual = usual_mounting(bare.movements, begin.log_mass.shape)
    tied = advance(
        declared,
        replace(begin, mounting=usual, terms=()),
        task(bare, tether, horizon, COARSE),
    )
    rows, member, failures = basins(bare, tied)
    gathered = without_thrust(take(tied.coordinates, rows))
    looser = advance(declared, gathered, task(bare, weaker, bare.steps, COARSE))
    rows, again, lost = basins(bare, looser)
    member = np.where(member < 0, -1, again[member])
    failures = dict(Counter(failures) + Counter(lost))
    gathered = without_thrust(take(looser.coordinates, rows))
    if not terms and swings_freely(bare):
        gathered = let_go(bare, gathered, horizon)
    mounting = take(begin.mounting, np.zeros(len(rows), dtype=int))  # every start's is as declared
    return *with_terms(replace(gathered, mounting=mounting), member, terms), failures


def swings_freely(problem: Problem) -> bool:
    """Does it swing by itself, leg or pendulum? Its first second tells how all of it goes on. That
    of what a motor moves may tell nothing, and what is driven later then runs away.
    """
    return set(problem.kinds) == {"passive"}


def let_go(problem: Problem, gathered: Coordinates, horizon: int) -> Coordinates:
    """The same, brought to the first second of the data once more, free of ties.

    A tie hides what a leg gets wrong. All of the motion and all that recordings own would make it
    leap from there, and take many steps to come back. What explains the first second by a leg that
    then runs away, as of a muscle that jerks, stays where it was.
    """
    freer = with_zero_free(without_scale(problem))
    free = advance(freer, gathered, task(problem, 0.0, horizon, COARSE))
    whole = advance(freer, free.coordinates, task(problem, 0.0, problem.steps, LOOKING))
    arrived = np.isfinite(free.loss) & np.isfinite(whole.loss)

    def chosen(new: np.ndarray, old: np.ndarray) -> np.ndarray:
        return np.where(arrived.reshape(-1, *[1] * (new.ndim - 1)), new, old)

    return without_thrust(jax.tree.map(chosen, free.coordinates, gathered))


def with_terms(
    gathered: Coordinates, member: np.ndarray, terms: tuple[Term, ...]
) -> tuple[Coordinates, np.ndarray]:
    """The basins with every beginning of the terms that a start of theirs has, and the basin that
    each start is of then. `terms` are of all starts.
    """
    each = np.stack([member, *jax.tree.leaves(terms)], axis=1)
    each, first, number = np.unique(each, axis=0, return_index=True, return_inverse=True)
    kept = each[:, 0] >= 0
    at = take(gathered, each[kept, 0].astype(int))
    inertia = np.exp(at.shared.log_inertia)
    own = tuple(over_inertia(take(term, first[kept]), inertia) for term in terms)
    return replace(at, terms=own), np.where(kept, np.cumsum(kept) - 1, -1)[number.ravel()]


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


def basins(problem: Problem, tied: Solved) -> tuple[np.ndarray, np.ndarray, dict[str, int]]:
    """The best start of every basin, each start's basin, and why starts were lost."""
    broken = ~np.isfinite(tied.loss)
    away = ~broken & (tied.loss > HOPELESS * finite(tied.loss).min())
    lost = broken | away
    place = data_coordinates(problem, tied.coordinates)
    cell = np.where(lost[:, None], np.inf, np.round(place / BASIN))
    order = np.lexsort((finite(tied.loss),))
    _, first, member = np.unique(cell[order], axis=0, return_index=True, return_inverse=True)
    rows = order[first]
    back = np.empty(order.size, dtype=int)
    back[order] = member.ravel()
    good = ~lost[rows]
    renumbered = np.cumsum(good) - 1
    failures = {
        reason: int(which.sum())
        for reason, which in (
            ("its motion could not be simulated", broken),
            ("it left the measured motion although tied to it", away),
        )
        if which.any()
    }
    if not good.any():
        raise ArithmeticError("no start could be simulated: is the recording what it says it is?")
    return rows[good], np.where(lost, -1, renumbered[back]), failures


def data_coordinates(problem: Problem, at: Coordinates) -> np.ndarray:
    """What the data can tell a start by, in typical steps: (start, coordinate)."""
    unit = scaled(at)
    shared = [unit.shared.gravity, unit.shared.stiffness, unit.shared.damping]
    if problem.tells_inertia:
        shared.append(unit.shared.log_inertia * BASIN)  # hardly told by now: a cell is a step wide
    return np.concatenate([np.stack(shared, axis=1), unit.own.torque], axis=1)


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
