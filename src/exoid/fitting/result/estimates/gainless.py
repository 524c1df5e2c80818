"""What a torque of unknown gain tells: nothing of J, and of what goes with it."""

from dataclasses import replace

from exoid.fitting.multistart.search_result import SearchResult
from exoid.fitting.result.estimates.scale import NO_GAIN
from exoid.fitting.solve.problem import Problem


def whatever_gain(problem: Problem, ended: SearchResult) -> SearchResult:
    """The same, its information that of a fit in which the torque's gain is an unknown as well.

    All torques are over J here, so log gain and log J are one direction e, and what is left for the
    others is I - I e e'I / e'I e: the ratios to J keep their errors, and nothing tells J. Where the
    search ended J is that over the gain, in no unit.
    """
    data = ended.local.data
    told = data[0]  # of log J, the first coordinate
    if problem.gain_known or not told[0] > 0:
        return ended
    left = data - told[:, None] * told / told[0]
    left[0], left[:, 0] = 0.0, 0.0  # rounding
    return replace(ended, local=replace(ended.local, data=left))


def why_none(problem: Problem) -> str | None:
    """Why J is none to be given where the gain is unknown; None where it is known."""
    return None if problem.gain_known else NO_GAIN
