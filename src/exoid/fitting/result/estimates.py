"""Quantities with their errors, units, and what determined them or why nothing did."""

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from exoid.fitting.misfit.uncertainty import HELD, Information, Shares
from exoid.fitting.model.belief import NAMES, Belief
from exoid.fitting.model.term_parameters import ratio_name, ratio_unit
from exoid.fitting.model.user_values import DECLARED, Means
from exoid.fitting.result.fit_result import Basis, Estimate
from exoid.fitting.result.remarks.limit_remarks import REACH
from exoid.fitting.result.remarks.upwards_remarks import NO_RIG, upside_down
from exoid.physics.parameter import Declaration, declarations
from exoid.physics.term import name_of
from exoid.physics.torque import CycleTorque

NO_RATIO = 1e-3  # a ratio below it, at a bound of zero, is the rounding of the bound
ON_BOUND = "at a bound: no error is quoted"
ON_YOUR_BOUND = "at your bound: no error is quoted"
FIXED = "fixed by you: ± 0 is no finding, and the errors of the others hold if it is true"
NO_GAIN = (
    "the sidecar says that the torque's gain is unknown (torque_known = false): only the ratios to "
    "J are told"
)
ABSENT = "the sidecar says that there is none"
NARROWED = "follows from a bound, not from the recording: ± holds only there, see --plot for more"
RATIOS = {  # name: symbol, title, unit
    "gravity_over_inertia": ("m l g / J", "gravity over inertia", "1/s^2"),
    "stiffness_over_inertia": ("c / J", "stiffness over inertia", "1/s^2"),
    "damping_over_inertia": ("d / J", "damping over inertia", "1/s"),
    "torque_over_inertia": ("tau / J", "torque over inertia", "1/s^2"),
}
MOMENT = "m l g", "gravity moment", "N m"
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


@dataclass(frozen=True, eq=False)
class Found:
    """A value of the best fit, its gradient, and what is known around it."""

    value: float
    gradient: np.ndarray
    information: Information
    held: bool  # on a bound, or by hand

    @cached_property
    def shares(self) -> Shares | None:
        """Who told it; None where nothing did."""
        return HELD if self.held else self.information.shares(self.gradient)

    def estimate(
        self, label: tuple[str, str, str], *, by_hand: Means | None = None, **more: Any
    ) -> Estimate:
        """With its error, where one is quoted, under its symbol, title and unit."""
        shares, error = self.shares, None
        if shares is not None and shares != HELD:
            error = self.information.standard_error(self.gradient)
        return Estimate(
            *label,
            value=None if shares is None else self.value,
            standard_error=0.0 if by_hand == "fix" else error,
            shares=shares,
            limited_by=self.information.limits(self.gradient),
            by_hand=by_hand,
            **more,
        )


def mean_of(basis: Basis, names: list[str], at_bound: set[str]) -> Found:
    """The mean over some quantities of the best fit, held where all of them are at a bound."""
    rows = [basis.problem.quantities.index(name) for name in names]
    value = float(basis.ended.best.quantities[0, rows].mean())
    gradient = basis.ended.local.quantities[rows].mean(axis=0)
    return Found(value, gradient, basis.information, at_bound.issuperset(names))


def parameter_estimate(name: str, belief: Belief, found: Found) -> Estimate:
    """One of m, J, l, d, c, with what determined it or why nothing did."""
    limits = belief.limits
    ends = float(getattr(limits.lower, name)), float(getattr(limits.upper, name))
    each = within(name, DECLARED[name], belief, found, ends)
    lower, upper = (end if np.isfinite(end) else None for end in ends)
    expected, deviation = expectation(belief, name)
    return replace(each, lower=lower, upper=upper, expected=expected, expected_deviation=deviation)


def within(
    name: str, declared: Declaration, belief: Belief, found: Found, ends: tuple[float, float]
) -> Estimate:
    """A parameter of the leg or of a term between its `ends`."""
    by_hand = belief.by_hand.means(name)
    if found.held or by_hand == "fix":  # the solver meets a bound to rounding; the bound is meant
        value = min(ends, key=lambda end: abs(found.value - end))
        found = replace(found, value=value, held=True)
    label = declared.symbol, declared.title, declared.unit
    return found.estimate(label, by_hand=by_hand, reason=why(found.shares, by_hand))


def expectation(belief: Belief, name: str) -> tuple[float | None, float | None]:
    """What is expected of a parameter, and its standard deviation where it has one."""
    own, weight = belief.by_hand.prior.get(name), float(belief.prior.weight)
    if own is not None:
        value, deviation = own
    elif belief.expected is not None and name in NAMES:
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
    # An error may be small only because a bound holds another quantity.
    return NARROWED if shares is not None and shares.source == "bound" else None


def goes_with_scale(own: Estimate, ratio: Estimate, inertia: Estimate) -> Estimate:
    """A quantity that is a told `ratio` times J^(1 or -1): where nothing tells J, nothing tells it.

    Near zero it would seem told: there J moves it little, but only as it was guessed.
    """
    if inertia.shares is not None or ratio.shares in (None, HELD):
        return own
    return goes_untold(own, SCALE_FREE)


def goes_with_mass(own: Estimate, mass: Estimate) -> Estimate:
    """The COM distance, which motion shows as m l alone: near zero, too, nothing tells it where
    nothing tells m.
    """
    return own if mass.shares is not None else goes_untold(own, MASS_AND_DISTANCE)


def goes_untold(own: Estimate, reason: str) -> Estimate:
    """Without its value, but where that is known from elsewhere than the motion."""
    if own.shares in (None, HELD) or own.by_hand in ("fix", "prior"):
        return own
    return without_value(own, reason)


def without_value(own: Estimate, reason: str) -> Estimate:
    """The quantity that nothing tells, and why."""
    return replace(own, value=None, standard_error=None, shares=None, reason=reason, limited_by={})


def with_reasons(parameters: dict[str, Estimate], rig: bool) -> dict[str, Estimate]:
    """Say of every missing value why it is missing."""
    scale_known = parameters["inertia"].value is not None

    gainless = NO_GAIN if parameters["inertia"].reason == NO_GAIN else None

    def missing(name: str) -> str:
        if scale_known and name in ("mass", "com_distance"):
            return MASS_AND_DISTANCE
        return SCALE_FREE_RIG if rig else SCALE_FREE

    return {
        name: replace(each, reason=gainless or missing(name)) if each.value is None else each
        for name, each in parameters.items()
    }


def estimate_torque(basis: Basis, names: list[str], at_bound: set[str]) -> Estimate:
    """The mean of tau over the voluntary segments of which these are the quantities."""
    declared = dict(declarations(CycleTorque))["amplitude"]
    found = mean_of(basis, names, at_bound)
    strongest = float(basis.problem.belief.limits.torque)
    bounded = bool(np.isfinite(strongest))
    return found.estimate(
        (declared.symbol, declared.title, declared.unit),
        lower=-strongest if bounded else None,
        upper=strongest if bounded else None,
        reason=ON_BOUND if found.shares == HELD else untold(found, SCALE_FREE),
    )


def estimate_ratios(basis: Basis, at_bound: set[str]) -> dict[str, Estimate]:
    """m l g / J, c / J, d / J, and tau / J as the mean over the voluntary segments."""
    problem, estimates = basis.problem, {}
    for name, label in RATIOS.items():
        wanted = problem.quantities_of(name)
        if not wanted:
            continue
        found, parameter = mean_of(basis, wanted, set()), name.removesuffix("_over_inertia")
        if parameter in problem.absent:
            estimates[name] = none_of(label)
            continue
        if parameter in ("gravity", "stiffness") and upside_down(basis.problem, basis.ended):
            estimates[name] = Estimate(*label, value=None, standard_error=None, reason=NO_RIG)
            continue
        at_zero = abs(found.value) < NO_RATIO
        found = replace(found, held=at_its_end(parameter, at_bound, at_zero))
        held = found.shares == HELD
        fixed = held and parameter in problem.belief.by_hand.fix
        if held and at_zero:  # no rounding of a bound at zero
            found = replace(found, value=0.0, held=True)
        estimates[name] = found.estimate(
            label,
            by_hand="fix" if fixed else None,
            reason=FIXED if fixed else ON_BOUND if held else untold(found, UNTOLD),
        )
    return estimates


def estimate_moment(basis: Basis, ratio: Estimate, inertia: Estimate) -> Estimate:
    """m l g, with the covariance of its factors m l g / J and J; none where one of them is not."""
    if "gravity" in basis.problem.absent:
        return none_of(MOMENT)
    each = (ratio, inertia)
    lost = next((one.reason for one in each if one.value is None), None)
    over, own = (mean_of(basis, [name], set()) for name in ("gravity_over_inertia", "inertia"))
    gradient = own.value * over.gradient + over.value * own.gradient
    held = any(one.shares == HELD and one.by_hand != "fix" for one in each)
    found = Found(own.value * over.value, gradient, basis.information, held)
    if any(one.value is None for one in each):
        return Estimate(*MOMENT, value=None, standard_error=None, reason=lost)
    return found.estimate(MOMENT, reason=why(found.shares, None))


def at_its_end(parameter: str, at_bound: set[str], at_zero: bool) -> bool:
    """Is the ratio itself on a limit? That of c is 0 alone, that of m l the reach of the leg."""
    if parameter == "gravity":
        return REACH in at_bound
    return parameter in at_bound and (parameter == "damping" or at_zero)


def none_of(label: tuple[str, str, str]) -> Estimate:
    """What a rig is said not to have."""
    return Estimate(
        *label, value=0.0, standard_error=0.0, shares=HELD, by_hand="fix", reason=ABSENT
    )


def label_of(each: Estimate) -> tuple[str, str, str]:
    """Its symbol, title and unit."""
    return each.symbol, each.title, each.unit


def without_gain(inertia: Estimate) -> Estimate:
    """The inertia where the torque's unit is unknown: only what is over J is told."""
    return without_value(inertia, NO_GAIN)


def untold(found: Found, reason: str) -> str | None:
    """The reason, where nothing tells a value."""
    return reason if found.shares is None else None


def estimate_terms(
    basis: Basis, at_bound: set[str], inertia: Estimate
) -> dict[str, dict[str, Estimate]]:
    """Every term's parameters; of those that go with J also what motion alone tells."""
    found: dict[str, dict[str, Estimate]] = {}
    for term in basis.problem.terms:
        own = found.setdefault(name_of(term), {})
        for name, declared in declarations(term):
            called = f"{name_of(term)}.{name}"
            own[name] = term_parameter(called, declared, basis, at_bound)
            if declared.inertia_power:
                ratio = term_ratio(called, declared, basis, own[name], at_bound)
                own[name] = goes_with_scale(own[name], ratio, inertia)
                own[ratio_name(name, declared)] = by_law(ratio, declared)
            own[name] = by_law(own[name], declared)
    return found


def by_law(each: Estimate, declared: Declaration) -> Estimate:
    """With what is off where the leg follows another law than the term."""
    return each if each.value is None else each.widened(declared.law * abs(each.value))


def term_parameter(name: str, declared: Declaration, basis: Basis, at_bound: set[str]) -> Estimate:
    """One parameter of a term, with what determined it or why nothing did."""
    belief, ends = basis.problem.belief, basis.problem.limits_of_term(name)
    each = within(name, declared, belief, mean_of(basis, [name], at_bound), ends)
    expected, deviation = expectation(belief, name)
    lost = SCALE_FREE if declared.inertia_power else UNTOLD
    return replace(
        each,
        lower=ends[0],
        upper=ends[1],
        expected=expected,
        expected_deviation=deviation,
        reason=lost if each.shares is None else each.reason,
    )


def term_ratio(
    name: str, declared: Declaration, basis: Basis, own: Estimate, at_bound: set[str]
) -> Estimate:
    """What motion alone tells of a term's parameter that goes with J; on a bound other than zero
    its inertia may still be another.
    """
    found = mean_of(basis, [ratio_name(name, declared)], set())
    found = replace(found, held=name in at_bound and own.value == 0.0)
    sign, word = ("/", "over") if declared.inertia_power > 0 else ("*", "times")
    label = f"{declared.symbol} {sign} J", f"{declared.title}, {word} J", ratio_unit(declared)
    ratio = found.estimate(label, reason=untold(found, UNTOLD))
    return replace(ratio, value=0.0) if own.value == 0.0 else ratio
