"""How far off the numbers of a leg are that moves as none of its body, were its times wrong.

An angle alone does not tell a leg from another one whose times are told a factor longer: m l g / J
and c / J go by its square, d / J by itself. What else would make it another leg, a body that is
none of it or masses that nobody declared, no motion tells from that.
"""

import numpy as np

from exoid.fitting.misfit.uncertainty import decomposed, inverse_times
from exoid.fitting.model.coordinates import layout
from exoid.fitting.multistart.search_result import SearchResult
from exoid.fitting.result.remarks.anatomy_remarks import Times, bent_explains, off_rate_of
from exoid.fitting.result.remarks.pushed.answer import Numbers, moved
from exoid.fitting.result.remarks.zero.leaning import Leaning
from exoid.fitting.solve.problem import Problem
from exoid.recordings.signal.both_sensors.sensor_scales import suspected

WHOLE = -0.3  # of a rate: a leg that is faster by more is no whole one, and its times may be right


def off_by_times(
    problem: Problem, ended: SearchResult, off: float, numbers: Numbers
) -> dict[str, float]:
    """How far every number may be off, as a standard deviation, where times may be `off` by this
    share of a sampling rate; nothing where they are not.
    """
    if not off:
        return {}
    clock = -np.copysign(suspected(off), off)  # a higher rate makes seconds shorter
    each = moved(numbers, ended, by_clock(ended, problem.estimated("clock"), clock))
    return {name: abs(one) for name, one in each.items()}


def by_clock(ended: SearchResult, entries: list[int], clock: float) -> np.ndarray:
    """The step to the fit of these recordings by another clock, in typical ones."""
    laid = layout(ended.point)
    at = laid.places.mounting.clock[entries].astype(int)
    free, step = np.delete(np.arange(laid.size), at), np.zeros(laid.size)
    step[at] = clock / laid.units[at]
    told = ended.local.data + ended.local.prior
    pulled = told[np.ix_(free, at)] @ step[at]
    step[free] = -inverse_times(decomposed(told[np.ix_(free, free)]), pulled)
    return step


def doubted_rate(problem: Problem, gravity: float, error: float, slack: Leaning | None) -> float:
    """By which share of it the sampling rate may be another, where that would make an ordinary leg
    of one with this m l g / J [1/s^2]: too low where it is positive. 0 where something vouches for
    the times, or it may be a leg as it is: one of this body, be it that its spring is `slack` in a
    bent position, or a stump.
    """
    if problem.times_vouched or not problem.estimated("clock"):
        return 0.0
    off = off_rate_of(problem.belief, gravity, error)
    as_it_is = off < WHOLE or bent_explains(problem.belief, gravity, slack, error)
    return 0.0 if as_it_is else off


def as_told(problem: Problem, rate: float) -> Times:
    """What is to be thought of the times: ± holds them where another `rate` is doubted; where a
    gyro does that does not agree with the encoder, they are among what may be wrong.
    """
    if rate:
        return "held"
    usual, at = [own[0].systematics.clock for own in problem.recordings], problem.estimated("clock")
    wide = (problem.deviation_of("clock")[at] > np.array(usual)[at]).any()
    return "vouched" if problem.times_vouched and not wide else "open"
