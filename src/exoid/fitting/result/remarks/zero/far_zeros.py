"""That an encoder's zero comes out farther off than was assumed."""

import numpy as np

from exoid.fitting.multistart.search_result import SearchResult
from exoid.fitting.result.remarks.zero.tilt_or_zero import either
from exoid.fitting.solve.problem import Problem

FAR = 4.0  # standard deviations of what was assumed: one recording in 16,000 by chance


def of_far_zeros(problem: Problem, ended: SearchResult) -> list[str]:
    """What the encoder of each recording would show with the knee extended, where that is far from
    0, that the ratios hold with it alone, and what to do. The zero of a rig is anywhere.
    """
    if problem.belief.rig:
        return []
    zeros, usual = ended.point.mounting.zero, problem.deviation_of("zero")
    return [
        said(problem, entry, float(zeros[entry]), float(usual[entry]))
        + alike(problem, ended, entry)
        for entry in problem.estimated("zero")
        if abs(float(zeros[entry])) > FAR * usual[entry]
    ]


def alike(problem: Problem, ended: SearchResult, entry: int) -> str:
    """That it may as well be the thigh that is tilted, where it may."""
    found = either(problem, ended, entry)
    return f" {found.sentence}" if found else ""


def said(problem: Problem, entry: int, zero: float, usual: float) -> str:
    """The same of one recording; `zero` and what is `usual` in rad."""
    own = problem.recordings[entry]
    whose = f" of {own[0].source}" if len(problem.recordings) > 1 else ""
    by = "the sidecar says" if "zero" in own[0].systematics.declared else "is assumed"
    return (
        f"by this fit the encoder{whose} shows {np.degrees(zero):.3g} deg with the knee extended, "
        f"{abs(zero) / usual:.2g} times the ± {np.degrees(usual):.2g} deg that {by}: m l g / J and "
        "c / J hold with that zero alone, and a spring that is slack at another angle looks alike. "
        "Look what the encoder shows there, and say it in [sensors]: angle_zero_deg, or --zero "
        "hanging where 0 is the hanging leg, or a smaller angle_zero_uncertainty_deg where it is 0."
    )
