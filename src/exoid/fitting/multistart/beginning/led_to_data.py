"""Starts that are led to the measured motion: from each to the basin in which it ends."""

from collections import Counter
from dataclasses import replace

import jax
import numpy as np

from exoid.fitting.data.pace import quickest
from exoid.fitting.model.coordinates import Coordinates, scaled
from exoid.fitting.model.term_parameters import over_inertia
from exoid.fitting.multistart.beginning.simpler_problems import (
    as_declared,
    with_zero_free,
    without_scale,
    without_terms,
)
from exoid.fitting.multistart.beginning.starts import usual_mounting
from exoid.fitting.multistart.beginning.tethers import COARSE, LOOKING, tethers, without_thrust
from exoid.fitting.solve.ask import advance, finite, take, task
from exoid.fitting.solve.problem import Problem
from exoid.fitting.solve.program_values import Solved
from exoid.physics.term import Term

BASIN = 0.2  # typical steps within which tied starts have come together
HOPELESS = 1e5  # times the best loss, of a tied start that leads nowhere
FIRST_HORIZON = 1.0  # s of every segment that a start sees first ...
HORIZON = 25.0  # ... or so many radians of what is quicker than a leg


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
