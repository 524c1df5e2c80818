"""The fit: many starts, brought to the data first, then to what anatomy and bounds allow."""

from collections import Counter
from dataclasses import replace

import jax
import numpy as np
from scipy.optimize import least_squares

from exoid.fitting.data.pace import quickest
from exoid.fitting.misfit.missed import Disturbance
from exoid.fitting.misfit.neighbourhood import penalties, weighed
from exoid.fitting.model.coordinates import Coordinates, Shared, scaled
from exoid.fitting.model.fixed_values import imposed
from exoid.fitting.model.prior import belief_residual
from exoid.fitting.model.term_parameters import over_inertia
from exoid.fitting.multistart.gross_errors import with_doubted_clocks, with_tilted_seats
from exoid.fitting.multistart.hold_to_declared import held, without_excuses
from exoid.fitting.multistart.join_terms import join_terms
from exoid.fitting.multistart.search_result import (
    FEASIBLE,
    LIMITED,
    LOOKING,
    SearchResult,
    scale_told,
)
from exoid.fitting.multistart.simpler_problems import (
    as_declared,
    with_inertia_kept,
    without_scale,
    without_terms,
)
from exoid.fitting.multistart.starts import coordinates, usual_mounting
from exoid.fitting.multistart.tethers import COARSE, FINE, tethers, without_thrust
from exoid.fitting.multistart.weight_by_kind import alone, explained, explained_apart
from exoid.fitting.solve.ask import BATCH, PAIR, advance, around, finite, left, lowest, take, task
from exoid.fitting.solve.problem import Problem
from exoid.fitting.solve.program_values import Solved
from exoid.physics.term import Term

BASIN = 0.2  # typical steps within which tied starts have come together
HOPELESS = 1e5  # times the best loss, of a tied start that leads nowhere
FIRST_HORIZON = 1.0  # s of every segment that a start sees first ...
HORIZON = 25.0  # ... or so many radians of what is quicker than a leg
PATIENCE = 4  # times that a search with limits goes on where its steps ran out: a long valley


def search(
    problem: Problem, starts: np.ndarray, terms: tuple[Term, ...] = (), *, near: bool = False
) -> tuple[Problem, SearchResult]:
    """Fit from every start (m, J, l, d, c, tau) with its terms.

    Starts are led to the measured motion, then run free; where the first is `near` the end, it does
    at once, and the others are other masses and inertias at its ratios. The best free fit meets
    prior and limits. Also the problem, its priors wider where a seat or a clock is unusual
    (`gross_errors.py`).
    """
    tether, _ = tethers(problem)
    greatest = 2 / problem.longest_step - 2 * tether
    begin = coordinates(starts, problem.movements, greatest, terms, problem.owned)
    if near:
        gathered, member, failures = take(begin, [0]), np.zeros(len(starts), dtype=int), {}
    else:
        gathered, member, failures = led_to_the_data(problem, begin, terms)
    free, member, failures = join_terms(without_scale(problem), gathered, member, failures)
    member, failures = without_lost(free, member, failures)
    problem, free, disturbance = with_what_is_missed(problem, free)
    free, disturbance, less = without_excuses(problem, free, disturbance)
    best = settle(held(problem, less, disturbance.scale), free, begin, disturbance)
    if problem.belief.by_hand.fix or problem.belief.by_hand.bound:
        disturbance = explained(problem, best)  # what no free leg would leave, but this one does
        best = settle(held(problem, less, disturbance.scale), free, begin, disturbance)
    local = around(problem, best, disturbance)
    doubted = with_doubted_clocks(problem, best, local)
    if doubted is not None:
        problem = doubted  # the suspicion widens errors, and moves no value
        local = around(problem, best, disturbance)
    return problem, SearchResult(free, member, failures, best, disturbance, begin, local)


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
    mounting = take(begin.mounting, np.zeros(len(rows), dtype=int))  # every start's is as declared
    return *with_terms(replace(gathered, mounting=mounting), member, terms), failures


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


def with_what_is_missed(problem: Problem, free: Solved) -> tuple[Problem, Solved, Disturbance]:
    """The free fits by what every kind of segment misses, on seats that are tilted if need be.

    Where one kind is explained by itself, others that are not say nothing of the seat.
    """
    again, found = weighed_by_kind(problem, free)
    if found.apart and found.kinds[found.trusted].cause is None:
        return problem, again, found
    wide, tilted = with_tilted_seats(problem, free)
    if wide is problem:
        return problem, again, found
    return wide, *weighed_by_kind(wide, tilted)


def weighed_by_kind(problem: Problem, free: Solved) -> tuple[Solved, Disturbance]:
    """What the residual holds; where kinds of segments differ, all free fits once more by it.

    The best of them begins anew where the kind that is weighed most ends by itself: that may be
    far from where all were weighed alike.
    """
    row = lowest(free)
    alike = explained(problem, free, row)
    found = explained_apart(problem, free, row, alike)
    if not found.apart:
        return free, found
    trusted = alone(problem, free, row, [found.trusted])
    starts = replaced(free.coordinates, row, take(trusted.coordinates, 0))
    asked = task(problem, 0.0, problem.steps, FINE)
    again = advance(problem, starts, asked, found.weighing(problem.kinds))
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


def settle(problem: Problem, free: Solved, begin: Coordinates, found: Disturbance) -> Solved:
    """The best free fit under prior and limits, from several inertias and masses."""
    best = lowest(free)
    lanes = max(PAIR, min(BATCH // len(problem.movements), begin.log_mass.size))
    one = take(free.coordinates, [best] * lanes)
    local = weighed(around(problem, free, row=best), found.scale)
    others = np.resize(np.arange(begin.log_mass.size), lanes)
    inertia, mass = (leaf[others].copy() for leaf in (begin.shared.log_inertia, begin.log_mass))
    typical = problem.belief.typical
    inertia[0] = np.log(typical["inertia"]) if "inertia" in typical else inertia[0]
    mass[0] = np.log(typical["mass"]) if "mass" in typical else mass[0]
    told = scale_told(local.data + local.declared) or loaded_rig(problem)
    if told:
        inertia = one.shared.log_inertia
    elif typical and problem.terms:
        inertia[0], mass[0] = as_believed(problem, take(one, 0), inertia[0], mass[0])
    shared = Shared(inertia, one.shared.gravity, one.shared.stiffness, one.shared.damping)
    starts = replace(one, shared=shared, log_mass=mass)
    fixed = problem.belief.by_hand.fix
    if fixed:  # how the data resist is asked where the point will be
        starts = imposed(starts, fixed)
        there = advance(problem, starts, task(problem, 0.0, problem.steps, LOOKING))
        local = weighed(around(problem, there), found.scale)
    asked = task(problem, 0.0, problem.steps, LIMITED, penalties(local))
    bounded = problem if told or problem.belief.typical else with_inertia_kept(problem)
    scale = found.scale * found.weighing(problem.kinds)
    ended = advance(bounded, starts, asked, scale)
    before = reached(ended)
    for _ in range(PATIENCE):
        if not ended.exhausted[least(ended)]:
            break
        ended = advance(bounded, ended.coordinates, asked, scale)
        if stands_still(reached(ended), before):
            break
        before = np.minimum(before, reached(ended))
    return take(ended, [least(ended)])


def loaded_rig(problem: Problem) -> bool:
    """Is it a rig with several known masses? Nothing else tells of its inertia: it stays free."""
    loads = {each.added_mass for each in problem.movements if not each.unplaced}
    return problem.belief.rig and len(loads) > 1


def as_believed(problem: Problem, free: Coordinates, *begin: float) -> np.ndarray:
    """log J and log m that are believed most at the ratios of a free fit: no data tell of them.

    Dry friction makes the loss rough, and a search that it stops would leave them where they were.
    """

    def misfit(at: np.ndarray) -> np.ndarray:
        shared = replace(free.shared, log_inertia=at[0])
        return belief_residual(
            problem.belief.prior, replace(free, shared=shared, log_mass=at[1]), np
        )

    return least_squares(misfit, begin).x


def reached(ended: Solved) -> np.ndarray:
    """Loss and violation of the best."""
    row = least(ended)
    return np.array([ended.loss[row], ended.violation[row]])


def stands_still(now: np.ndarray, lowest: np.ndarray) -> bool:
    """Are loss and violation both no lower than they once were?

    Limits that contradict what the data insist on leave a search with steps that lead nowhere.
    """
    return not np.any(lowest - now > [LIMITED, FEASIBLE])


def least(ended: Solved) -> int:
    """The best that keeps the limits, or the best."""
    feasible = np.where(ended.violation < FEASIBLE, finite(ended.loss), np.inf)
    return int(np.argmin(feasible if np.isfinite(feasible).any() else finite(ended.loss)))
