"""The first instants of a leg whose recording begins with its release: was it let go at once?

A hand that lets go within a tenth of a second, soft cuffs and play all make the sensors begin late.
Where the rest of the movement fits without these instants and they do not, they tell of nothing.
"""

import numpy as np
from scipy.special import chdtri

from exoid.fitting.data.movement import Movement, weightless
from exoid.fitting.misfit.missed import NOISY, Disturbance
from exoid.fitting.multistart.search_result import SearchResult
from exoid.fitting.solve.problem import Problem

WORSE = 3.0  # times what is missed elsewhere, a sample
RARE = 1e-4  # chance by which noise does it in a movement


def without_first_instants(movements: list[Movement]) -> list[Movement]:
    """The same, where a hand may be on a leg that seems to begin free nothing weighs."""
    return [masked(each) for each in movements]


def masked(each: Movement) -> Movement:
    count = 0 if each.extent is None else each.extent.doubted
    if not count:
        return each
    return weightless(each, np.arange(each.angle.size) < count, late=count)


def doubtful(problem: Problem, ended: SearchResult) -> bool:
    """Do the first instants of any movement miss more than noise does?"""
    return any(starts_off(problem, ended, number) for number in range(len(problem.movements)))


def disturbed(ended: SearchResult) -> bool:
    """Is there more in the residual than noise?"""
    return beyond_noise(ended.disturbance)


def beyond_noise(found: Disturbance) -> bool:
    """The same of what is missed."""
    trusted = found.kinds[found.trusted]
    return trusted.cause is not None or trusted.noise > NOISY


def starts_off(problem: Problem, ended: SearchResult, number: int) -> bool:
    """Those of a movement that seems to begin free, measured by what it misses elsewhere."""
    each, seen, best = problem.movements[number], problem.observation, ended.best
    count = 0 if each.extent is None else each.extent.doubted
    rows = problem.own_rows(number)
    channels = (
        (each.angle, best.angle, seen.angle_weight),
        (each.angular_velocity, best.angular_velocity, seen.velocity_weight),
    )
    left = [
        (measured - simulated[0, number][rows]) * np.asarray(weight[number])[rows]
        for measured, simulated, weight in channels
        if measured is not None
    ]
    first = np.concatenate([one[:count] for one in left])
    usual = max(1.0, float(np.nanmean(np.concatenate([one[count:] for one in left]) ** 2)))
    known = int(np.sum(~np.isnan(first)))
    return bool(np.nansum(first**2) > chdtri(known, RARE) * usual)


def told(each: Movement) -> int:
    """Numbers that its sensors tell."""
    channels = [one for one in (each.angle, each.angular_velocity) if one is not None]
    return sum(int(np.sum(~np.isnan(one))) for one in channels)


def differ(
    whole: list[Movement], of_whole: SearchResult, rest: list[Movement], of_rest: SearchResult
) -> bool:
    """Do the first instants miss more than the rest does?"""
    left, every = (sum(map(told, each)) for each in (rest, whole))
    usual = max(1.0, float(of_rest.best.misfit[0]) / left)
    missed = float(of_whole.best.misfit[0] - of_rest.best.misfit[0])
    return missed > WORSE * usual * (every - left)
