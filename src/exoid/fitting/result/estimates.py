"""Quantities with their errors, units, and what determined them or why nothing did."""

from dataclasses import replace

import numpy as np

from exoid.fitting.misfit.uncertainty import HELD, Information, Shares
from exoid.fitting.model.belief import Belief
from exoid.fitting.model.term_parameters import ratio_name, ratio_unit
from exoid.fitting.model.user_values import Means
from exoid.fitting.multistart.ended import Ended
from exoid.fitting.result.fit_result import Estimate
from exoid.fitting.solve.problem import Problem
from exoid.physics.leg import LegParameters
from exoid.physics.parameter import Declaration, declarations
from exoid.physics.term import name_of
from exoid.physics.torque import CycleTorque

NO_RATIO = 1e-3  # a ratio below it, at a bound of zero, is the rounding of the bound
ON_BOUND = "at a bound: no error is quoted"
ON_YOUR_BOUND = "at your bound: no error is quoted"
FIXED = "fixed by you: ± 0 is no finding, and the errors of the others hold if it is true"
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
UNTOLD = "nothing in this recording tells it"
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
    by_hand = belief.by_hand.means(name)
    held = name in at_bound or by_hand == "fix"
    shares = HELD if held else information.shares(gradient)
    lower, upper = (
        float(getattr(limit, name)) for limit in (belief.limits.lower, belief.limits.upper)
    )
    if held:  # the solver meets a bound to rounding; the bound itself is meant
        value = lower if abs(value - lower) < abs(value - upper) else upper
    quoted = shares is not None and shares != HELD
    error = information.standard_error(gradient) if quoted else None
    expected, deviation = expectation(belief, name)
    return Estimate(
        symbol=declared.symbol,
        title=declared.title,
        unit=declared.unit,
        value=None if shares is None else value,
        standard_error=0.0 if by_hand == "fix" else error,
        expected=expected,
        expected_deviation=deviation,
        lower=lower if np.isfinite(lower) else None,
        upper=upper if np.isfinite(upper) else None,
        shares=shares,
        reason=why(shares, by_hand),
        limited_by=information.limits(gradient),
        by_hand=by_hand,
    )


def expectation(belief: Belief, name: str) -> tuple[float | None, float | None]:
    """What is expected of a parameter, and its standard deviation where it has one."""
    weight = float(belief.prior.weight)
    own = belief.by_hand.prior.get(name)
    if own is not None:
        value, deviation = own
    elif belief.expected is not None:
        one = getattr(belief.expected, name)
        value, deviation = one.value, None if belief.raw else one.standard_deviation
    else:
        return None, None
    known = deviation is not None and weight > 0
    return value, deviation / np.sqrt(weight) if known else None


def why(shares: Shares | None, by_hand: Means | None) -> str | None:
    """Why an error is none, or small."""
    if by_hand == "fix":
        return FIXED
    if shares == HELD:
        return ON_YOUR_BOUND if by_hand == "bound" else ON_BOUND
    return NARROWED if narrowed(shares) else None


def narrowed(shares: Shares | None) -> bool:
    """Is the error small only because a bound holds another quantity?"""
    return shares is not None and shares.source == "bound"


def goes_with_scale(own: Estimate, ratio: Estimate, inertia: Estimate) -> Estimate:
    """A quantity that is a told `ratio` times J^(1 or -1): where nothing tells J, nothing tells it.

    Near zero it would seem told: there J moves it little, but only as it was guessed.
    """
    told = own.shares not in (None, HELD) and ratio.shares not in (None, HELD)
    if inertia.shares is not None or not told or own.by_hand in ("fix", "prior"):
        return own
    return replace(
        own, value=None, standard_error=None, shares=None, reason=SCALE_FREE, limited_by={}
    )


def with_reasons(parameters: dict[str, Estimate], rig: bool) -> dict[str, Estimate]:
    """Say of every missing value why it is missing."""
    scale_known = parameters["inertia"].value is not None

    def missing(name: str) -> str:
        if scale_known and name in ("mass", "com_distance"):
            return MASS_AND_DISTANCE
        return SCALE_FREE_RIG if rig else SCALE_FREE

    return {
        name: replace(each, reason=missing(name)) if each.value is None else each
        for name, each in parameters.items()
    }


def estimate_torque(
    numbers: list[int],
    problem: Problem,
    ended: Ended,
    information: Information,
    at_bound: set[str],
    strongest: float,
) -> Estimate:
    """The mean of tau over these voluntary segments; `strongest` is its limit."""
    declared = dict(declarations(CycleTorque))["amplitude"]
    rows = [problem.quantities.index(f"torque_amplitude[{number}]") for number in numbers]
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
        lower=-strongest if np.isfinite(strongest) else None,
        upper=strongest if np.isfinite(strongest) else None,
        shares=shares,
        reason=None if known else SCALE_FREE,
        limited_by=information.limits(gradient),
    )


def error_of(gradient: np.ndarray, information: Information, shares: Shares | None) -> float | None:
    """The standard error, where one is quoted."""
    return None if shares in (None, HELD) else information.standard_error(gradient)


def ratio_value(value: float, shares: Shares | None) -> float | None:
    """What is quoted: nothing that is not told, and no rounding of a bound at zero."""
    if shares is None:
        return None
    return 0.0 if shares == HELD and abs(value) < NO_RATIO else value


def estimate_ratios(
    problem: Problem, ended: Ended, information: Information, at_bound: set[str]
) -> dict[str, Estimate]:
    """m l g / J, c / J, d / J, and tau / J as the mean over the voluntary segments."""
    names = problem.quantities
    voluntary = [number for number, each in enumerate(problem.movements) if each.voluntary]
    estimates = {}
    for name in RATIOS:
        wanted = [name] if name in names else [f"{name}[{number}]" for number in voluntary]
        if not wanted:
            continue
        rows = [names.index(each) for each in wanted]
        value = ended.best.quantities[0, rows].mean()
        gradient = ended.local.quantities[rows].mean(axis=0)
        parameter = name.removesuffix("_over_inertia")
        at_zero = parameter == "stiffness" and abs(value) < NO_RATIO
        held = parameter in at_bound and (parameter == "damping" or at_zero)
        shares = HELD if held else information.shares(gradient)
        held = shares == HELD
        fixed = held and parameter in problem.belief.by_hand.fix
        estimates[name] = Estimate(
            *RATIOS[name],
            value=ratio_value(float(value), shares),
            standard_error=0.0 if fixed else error_of(gradient, information, shares),
            shares=shares,
            reason=FIXED if fixed else ON_BOUND if held else UNTOLD if shares is None else None,
            limited_by=information.limits(gradient),
            by_hand="fix" if fixed else None,
        )
    return estimates


def estimate_terms(
    problem: Problem,
    ended: Ended,
    information: Information,
    at_bound: set[str],
    inertia: Estimate,
) -> dict[str, dict[str, Estimate]]:
    """Every term's parameters; of those that go with J also what motion alone tells."""
    rows = {name: row for row, name in enumerate(problem.quantities)}

    def row_of(name: str) -> tuple[float, np.ndarray]:
        row = rows[name]
        return float(ended.best.quantities[0, row]), ended.local.quantities[row]

    found: dict[str, dict[str, Estimate]] = {}
    for term in problem.terms:
        own = found.setdefault(name_of(term), {})
        for name, declared in declarations(term):
            called = f"{name_of(term)}.{name}"
            value, gradient = row_of(called)
            own[name] = term_parameter(
                called, declared, problem, value, information, gradient, at_bound
            )
            if declared.inertia_power:
                value, gradient = row_of(ratio_name(called, declared))
                shares = own[name].shares if called in at_bound else information.shares(gradient)
                sign, word = ("/", "over") if declared.inertia_power > 0 else ("*", "times")
                ratio = Estimate(
                    symbol=f"{declared.symbol} {sign} J",
                    title=f"{declared.title}, {word} J",
                    unit=ratio_unit(declared),
                    value=0.0 if own[name].value == 0.0 else None if shares is None else value,
                    standard_error=error_of(gradient, information, shares),
                    shares=shares,
                    reason=UNTOLD if shares is None else None,
                    limited_by=information.limits(gradient),
                )
                own[name] = goes_with_scale(own[name], ratio, inertia)
                own[ratio_name(name, declared)] = ratio
    return found


def term_parameter(
    name: str,
    declared: Declaration,
    problem: Problem,
    value: float,
    information: Information,
    gradient: np.ndarray,
    at_bound: set[str],
) -> Estimate:
    """One parameter of a term, with what determined it or why nothing did."""
    by_hand = problem.belief.by_hand.means(name)
    held = name in at_bound or by_hand == "fix"
    shares = HELD if held else information.shares(gradient)
    lower, upper = problem.limits_of_term(name)
    if held:
        value = lower if abs(value - lower) < abs(value - upper) else upper
    expected, deviation = problem.belief.by_hand.prior.get(name, (None, None))
    lost = SCALE_FREE if declared.inertia_power else UNTOLD
    return Estimate(
        symbol=declared.symbol,
        title=declared.title,
        unit=declared.unit,
        value=None if shares is None else value,
        standard_error=0.0 if by_hand == "fix" else error_of(gradient, information, shares),
        expected=expected,
        expected_deviation=deviation,
        lower=lower,
        upper=upper,
        shares=shares,
        reason=lost if shares is None else why(shares, by_hand),
        limited_by=information.limits(gradient),
        by_hand=by_hand,
    )
