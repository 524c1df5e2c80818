"""What motion alone tells: the ratios to J, and m l g."""

from dataclasses import replace

from exoid.fitting.misfit.uncertainty import HELD
from exoid.fitting.result.estimates.basis import Basis
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.estimates.found import FIXED, ON_BOUND, Found, mean_of, why
from exoid.fitting.result.estimates.scale import UNTOLD
from exoid.fitting.result.remarks.limit_remarks import REACH
from exoid.fitting.result.remarks.upwards_remarks import NO_RIG, upside_down

NO_RATIO = 1e-3  # a ratio below it, at a bound of zero, is the rounding of the bound
ABSENT = "the sidecar says that there is none"
RATIOS = {  # name: symbol, title, unit
    "gravity_over_inertia": ("m l g / J", "gravity over inertia", "1/s^2"),
    "stiffness_over_inertia": ("c / J", "stiffness over inertia", "1/s^2"),
    "damping_over_inertia": ("d / J", "damping over inertia", "1/s"),
    "torque_over_inertia": ("tau / J", "torque over inertia", "1/s^2"),
}
MOMENT = "m l g", "gravity moment", "N m"


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
            reason=FIXED if fixed else ON_BOUND if held else found.untold(UNTOLD),
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
    fixed = {"mass", "com_distance"} <= set(basis.problem.belief.by_hand.fix)
    by_hand = "fix" if fixed else None
    return found.estimate(MOMENT, by_hand=by_hand, reason=why(found.shares, by_hand))


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
