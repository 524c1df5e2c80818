"""Quantities with their errors, units, and what determined them or why nothing did."""

from dataclasses import replace

import numpy as np

from exoid.fit.belief import NAMES, Belief
from exoid.fit.coordinates import QUANTITIES
from exoid.fit.multistart import Ended
from exoid.fit.problem import Problem
from exoid.fit.result import Estimate
from exoid.fit.uncertainty import HELD, Information, Shares
from exoid.physics.leg import LegParameters
from exoid.physics.parameter import declarations
from exoid.physics.torque import CycleTorque

NO_RATIO = 1e-3  # a ratio below it, at a bound of zero, is the rounding of the bound
ON_BOUND = "at a bound: no error is quoted"
NARROWED = "follows from a bound, not from the recording: ± holds only there, see --plot for more"
RATIOS = {  # name: symbol, title, unit
    "gravity_over_inertia": ("m l g / J", "gravity over inertia", "1/s^2"),
    "stiffness_over_inertia": ("c / J", "stiffness over inertia", "1/s^2"),
    "damping_over_inertia": ("d / J", "damping over inertia", "1/s"),
    "torque_over_inertia": ("tau / J", "torque over inertia", "1/s^2"),
}
SCALE_FREE = (
    "motion alone fixes only the ratios to J: record a drop with a known mass, measure the torque, "
    "or give body mass and height"
)
SCALE_FREE_RIG = (
    "motion alone fixes only the ratios to J: record it with a known mass, or with a measured "
    "torque that varies"
)
MASS_AND_DISTANCE = "motion shows only the product m l; one of them must come from elsewhere"


def parameter_estimate(
    name: str,
    belief: Belief,
    value: float,
    information: Information,
    gradient: np.ndarray,
    at_bound: set[str],
) -> Estimate:
    """One of m, J, l, d, c, with what determined it or why nothing did."""
    declared = dict(declarations(LegParameters))[name]
    expected = None if belief.expected is None else getattr(belief.expected, name)
    deviation = np.inf
    if expected is not None:
        given = float(getattr(belief.prior.standard_deviation, name))
        weight = float(belief.prior.weight)
        deviation = given / np.sqrt(weight) if weight > 0 else np.inf
    shares = HELD if name in at_bound else information.shares(gradient)
    lower, upper = (
        float(getattr(limit, name)) for limit in (belief.limits.lower, belief.limits.upper)
    )
    if name in at_bound:  # the solver meets a bound to rounding; the bound itself is meant
        value = lower if abs(value - lower) < abs(value - upper) else upper
    quoted = shares is not None and shares != HELD
    return Estimate(
        symbol=declared.symbol,
        title=declared.title,
        unit=declared.unit,
        value=None if shares is None else value,
        standard_error=information.standard_error(gradient) if quoted else None,
        expected=None if expected is None else expected.value,
        expected_deviation=deviation if np.isfinite(deviation) and not belief.raw else None,
        lower=lower if np.isfinite(lower) else None,
        upper=upper if np.isfinite(upper) else None,
        shares=shares,
        reason=ON_BOUND if shares == HELD else NARROWED if narrowed(shares) else None,
        limited_by=information.limits(gradient),
    )


def narrowed(shares: Shares | None) -> bool:
    """Is the error small only because a bound holds another quantity?"""
    return shares is not None and shares.source == "bound"


def with_reasons(parameters: dict[str, Estimate], rig: bool) -> dict[str, Estimate]:
    """Say of every missing value why it is missing."""
    scale_known = parameters["inertia"].value is not None

    def why(name: str) -> str:
        if scale_known and name in ("mass", "com_distance"):
            return MASS_AND_DISTANCE
        return SCALE_FREE_RIG if rig else SCALE_FREE

    return {
        name: replace(each, reason=why(name)) if each.value is None else each
        for name, each in parameters.items()
    }


def estimate_torque(
    numbers: list[int], ended: Ended, information: Information, at_bound: set[str]
) -> Estimate:
    """The mean of tau over these voluntary segments."""
    declared = dict(declarations(CycleTorque))["amplitude"]
    rows = QUANTITIES + np.array(numbers)
    gradient = ended.local.quantities[rows].mean(axis=0)
    held = all(f"torque_amplitude[{number}]" in at_bound for number in numbers)
    shares = HELD if held else information.shares(gradient)
    known = shares is not None
    quoted = known and shares != HELD
    return Estimate(
        symbol=declared.symbol,
        title=declared.title,
        unit=declared.unit,
        value=float(ended.best.quantities[0, rows].mean()) if known else None,
        standard_error=information.standard_error(gradient) if quoted else None,
        lower=declared.lower,
        upper=declared.upper,
        shares=shares,
        reason=None if known else SCALE_FREE,
        limited_by=information.limits(gradient),
    )


def estimate_ratios(
    problem: Problem, ended: Ended, information: Information, at_bound: set[str]
) -> dict[str, Estimate]:
    """m l g / J, c / J, d / J, and tau / J as the mean over the voluntary segments."""
    first, end = len(NAMES), QUANTITIES
    values = list(ended.best.quantities[0, first:end])
    gradients = list(ended.local.quantities[first:end])
    voluntary = [number for number, each in enumerate(problem.movements) if each.voluntary]
    if voluntary:
        rows = end + len(problem.movements) + np.array(voluntary)
        values.append(ended.best.quantities[0, rows].mean())
        gradients.append(ended.local.quantities[rows].mean(axis=0))
    estimates = {}
    for name, value, gradient in zip(RATIOS, values, gradients, strict=False):
        held = name.removesuffix("_over_inertia") in at_bound & {"damping"}
        shares = HELD if held else information.shares(gradient)
        held = shares == HELD
        estimates[name] = Estimate(
            *RATIOS[name],
            value=0.0 if held and abs(value) < NO_RATIO else float(value),
            standard_error=None if held or shares is None else information.standard_error(gradient),
            shares=shares,
            reason=ON_BOUND if held else None,
            limited_by=information.limits(gradient),
        )
    return estimates
