"""Where the best free fit goes under prior and limits."""

from dataclasses import replace

import numpy as np

from exoid.fitting.misfit.missed import Disturbance
from exoid.fitting.misfit.neighbourhood import derivative, penalties, weighed
from exoid.fitting.model.coordinates import (
    TYPICAL,
    Coordinates,
    Shared,
    flattened,
    places,
    unflattened,
)
from exoid.fitting.model.fixed_values import imposed
from exoid.fitting.model.prior import belief_residual
from exoid.fitting.multistart.beginning.simpler_problems import with_inertia_kept
from exoid.fitting.multistart.beginning.tethers import LOOKING
from exoid.fitting.multistart.search_result import FEASIBLE, LIMITED, scale_told
from exoid.fitting.solve.ask import BATCH, PAIR, advance, around, finite, lowest, take, task
from exoid.fitting.solve.problem import Problem
from exoid.fitting.solve.program_values import Solved

PATIENCE = 4  # times that a search with limits goes on where its steps ran out: a long valley
TURNS, HALVED = 10, 6  # steps towards what is believed most, and how often one that leaps is halved
NEARBY = 1e-3  # of a typical step: no nearer
SIZES = np.array([TYPICAL.shared.log_inertia, TYPICAL.log_mass])  # of such steps


def settle(problem: Problem, free: Solved, begin: Coordinates, found: Disturbance) -> Solved:
    """The best free fit under prior and limits, from several inertias and masses."""
    best = lowest(free)
    lanes = max(PAIR, min(BATCH // len(problem.movements), begin.log_mass.size // 2))
    one = take(free.coordinates, [best] * lanes)
    looked, row = free, best
    if problem.tells_inertia:  # also where the search kept an inertia, and saw nothing of it
        row = 0
        looked = advance(problem, one, task(problem, 0.0, problem.steps, LOOKING))
    local = weighed(around(problem, looked, row=row), found.scale)
    others = np.resize(np.arange(begin.log_mass.size), lanes)
    inertia, mass = (leaf[others].copy() for leaf in (begin.shared.log_inertia, begin.log_mass))
    typical = problem.belief.typical
    inertia[0] = np.log(typical["inertia"]) if "inertia" in typical else inertia[0]
    mass[0] = np.log(typical["mass"]) if "mass" in typical else mass[0]
    told = scale_told(local.data + local.declared) or loaded_rig(problem)
    if told:
        inertia = one.shared.log_inertia
    elif typical:
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


@np.errstate(over="ignore", divide="ignore", invalid="ignore")  # of a leap, which is then halved
def as_believed(problem: Problem, free: Coordinates, inertia: float, mass: float) -> np.ndarray:
    """log J and log m that are believed most at the ratios of a free fit, by steps from these: no
    data tell of them, and a search ends soon that begins there.

    Dry friction makes the loss rough, and a search that it stops would leave them where they were.
    """
    flat, at = flattened(free), places(free)
    rows = [int(at.shared.log_inertia), int(at.log_mass)]

    def belief(two: np.ndarray) -> np.ndarray:
        values = np.multiply.outer(flat, np.ones_like(two[0]))
        values[rows] = two
        return belief_residual(problem.belief.prior, unflattened(values, free), np)

    point = np.array([inertia, mass])
    for _ in range(TURNS):
        slopes, before = derivative(belief, point), belief(point)
        if not np.isfinite(slopes).all():
            break
        step = np.linalg.lstsq(slopes, -before, rcond=None)[0]
        towards = (point + step / 2**halved for halved in range(HALVED))
        better = (one for one in towards if np.sum(belief(one) ** 2) < np.sum(before**2))
        nearer = next(better, None)
        if nearer is None or np.abs(step / SIZES).max() < NEARBY:
            break
        point = nearer
    return point


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
