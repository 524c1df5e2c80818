"""A seat that is clearly tilted: the width of its tilt's prior follows its marginal likelihood."""

import numpy as np

from exoid.fitting.misfit.missed import Disturbance
from exoid.fitting.misfit.neighbourhood import declared_slopes
from exoid.fitting.model.systematics import FOOT
from exoid.fitting.multistart.beginning.tethers import FINE
from exoid.fitting.multistart.rare import Rare, found, seats
from exoid.fitting.multistart.weight_by_kind import likelihood
from exoid.fitting.solve.ask import advance, lowest, take, task, told_at
from exoid.fitting.solve.problem import Problem
from exoid.fitting.solve.program_values import Solved

CONVINCING = 3.0  # gain of log likelihood from which on a seat is held for tilted
STEEPEST = np.radians(5.0)  # standard deviation of its tilt
LYING = 2.0  # times it: a fit with a seat that is tilted by more takes it for something else


def with_tilted_seats(
    problem: Problem, free: Solved, row: int, left: Disturbance
) -> tuple[Problem, Solved]:
    """The same, its priors wider for seats that are clearly tilted, and all free fits under them.
    `left` is what is in the residual of the best `row`, and how its kinds of segments are weighed.

    Seen as if only white noise were in the residual, a tilt may be anything that the model misses:
    it is believed where it explains the residual better than that would.
    """
    wide = tilted(problem, free, row)
    if wide is None:
        return problem, free
    asked, weighing = task(wide, 0.0, wide.steps, FINE), left.weighing(problem.kinds)
    copies = [row] * (1 if problem.terms else free.loss.size)  # a program of many lanes is there
    again = advance(wide, take(free.coordinates, copies), asked, weighing)
    gain = likelihood(wide, again, 0, left) - likelihood(problem, free, row, left)
    price = np.log(wide.deviation_of("tilt") / problem.deviation_of("tilt")).sum()
    steepest = float(np.abs(again.coordinates.mounting.tilt[lowest(again)]).max())
    if steepest > LYING * STEEPEST or not gain - price > CONVINCING:
        return problem, free
    return wide, advance(wide, free.coordinates, asked, weighing)


def tilted(problem: Problem, free: Solved, row: int) -> Problem | None:
    """With wider priors for the seats whose tilt stands out; None where none does."""
    if "tilt" not in problem.owned:
        return None
    declared = declared_slopes(take(free.coordinates, row), problem.belief.prior)
    total = white(problem, free, row) + declared.T @ declared
    deviation = problem.deviation_of("tilt").copy()
    chosen = False
    for seat in seats(problem):
        one = Rare("tilt", seat, STEEPEST, FOOT)
        each, usual = found(problem, free, row, one, total), deviation[seat[0]]
        wide = min(np.sqrt(max(each.value**2 - each.variance, 0.0)), STEEPEST)
        if wide > usual and each.likelihood(wide) - each.likelihood(usual) > CONVINCING:
            deviation[seat], chosen = wide, True
    return problem.widened(tilt=deviation) if chosen else None


def white(problem: Problem, at: Solved, row: int) -> np.ndarray:
    """What the data tell at an end point, were all that is left there white noise."""
    noise = max(1.0, float(at.misfit[row]) / int(problem.samples.sum()))
    return told_at(problem, at, row) / noise
