"""That an encoder's zero comes out farther off than was assumed, or a thigh that is tilted.

With the encoder's psi = phi + zero gravity acts as cos(psi + tilt - zero): motion tells that
difference. Whose it is, only the constant torque c zero of the spring shows, as one that is slack
at another angle has it, too.
What a fit would be whose tilted thigh is an encoder's zero, or the other way round, `Either` says.
"""

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from exoid.fitting.misfit.uncertainty import decomposed, inverse_times
from exoid.fitting.model.coordinates import layout
from exoid.fitting.model.systematics import OF_THE_REST
from exoid.fitting.multistart.search_result import SearchResult
from exoid.fitting.solve.problem import Problem

BOTH = ("gravity_over_inertia", "stiffness_over_inertia")
ALIKE = 0.2  # of tilt - zero, by which it may change where a straight line still holds
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


@dataclass(frozen=True)
class Either:
    """The ratios of `BOTH` [1/s^2], were all of tilt - zero the one's, or the other's."""

    apart: Annotated[float, "rad"]
    as_zero: tuple[float, float]
    as_tilt: tuple[float, float]

    @property
    def sentence(self) -> str:
        """What the recording tells of the two, and what holds."""
        (gravity, spring), (steeper, stiffer) = self.as_zero, self.as_tilt
        return (
            "A tilted thigh and an encoder whose zero is off look nearly alike: the recording "
            f"tells the {np.degrees(abs(self.apart)):.2g} deg between the two, hardly whose they "
            f"are. d / J holds either way; m l g / J and c / J would be {gravity:.4g} and "
            f"{spring:.3g} 1/s^2 were all the encoder's, {steeper:.4g} and {stiffer:.3g} 1/s^2 "
            "were all the thigh's."
        )


def either(problem: Problem, ended: SearchResult, entry: int) -> Either | None:
    """The same of one recording, by a straight line from the fit; None where it has not both, and
    where a line does not reach so far.
    """
    if not all(problem.estimates(name, entry) for name in OF_THE_REST):
        return None
    zero, tilt = (float(getattr(ended.point.mounting, name)[entry]) for name in OF_THE_REST)
    rows = [problem.quantities.index(name) for name in BOTH]
    here, slopes = ended.best.quantities[0, rows], ended.local.quantities[rows]
    found = []
    for none in reversed(OF_THE_REST):
        step, apart = without(none, problem, ended, entry)
        if not abs(apart - (tilt - zero)) < ALIKE * abs(tilt - zero):
            return None
        found.append(tuple((here + slopes @ step).tolist()))
    return Either(tilt - zero, *found)


def without(
    none: str, problem: Problem, ended: SearchResult, entry: int
) -> tuple[np.ndarray, float]:
    """The step to the fit whose `none` is 0 and whose other one nothing holds, and its tilt - zero.

    What both are known by is taken from the information H; its pull g is in balance with the data.
    """
    laid, point = layout(ended.point), ended.point
    at = [int(getattr(laid.places.mounting, name)[entry]) for name in OF_THE_REST]
    values = np.array([float(getattr(point.mounting, name)[entry]) for name in OF_THE_REST])
    deviations = np.array([problem.deviation_of(name)[entry] for name in OF_THE_REST])
    known = (laid.units[at] / deviations) ** 2
    told, pull = ended.local.data + ended.local.prior, np.zeros(laid.size)
    told[at, at] -= known
    pull[at] = -known * values / laid.units[at]
    gone = OF_THE_REST.index(none)
    free, step = np.delete(np.arange(laid.size), at[gone]), np.zeros(laid.size)
    step[at[gone]] = -values[gone] / laid.units[at[gone]]
    left = -(pull + told @ step)[free]
    step[free] = inverse_times(decomposed(told[np.ix_(free, free)]), left)
    zero, tilt = values + laid.units[at] * step[at]
    return step, float(tilt - zero)
