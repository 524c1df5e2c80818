"""The leg's numbers, as wide as all that the search cannot see makes them."""

import numpy as np

from exoid.fitting.model.belief import NAMES
from exoid.fitting.multistart.at_odds import at_odds
from exoid.fitting.multistart.pulled_by_declared import led_astray
from exoid.fitting.multistart.seldom import hung_elsewhere, slanted
from exoid.fitting.result.describing.leg_numbers import DISTANCE, LegNumbers
from exoid.fitting.result.estimates.basis import Basis
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.estimates.found import mean_of
from exoid.fitting.result.estimates.moved import Moved
from exoid.fitting.result.estimates.parameters import parameter_estimate
from exoid.fitting.result.estimates.ratios import (
    estimate_ratios,
    label_of,
    none_of,
)
from exoid.fitting.result.estimates.scale import goes_with_mass, goes_with_scale
from exoid.fitting.result.remarks.anatomy_remarks import SWING


def of_leg(basis: Basis, at_bound: set[str], moved: Moved) -> LegNumbers:
    """Ratios and parameters, wider by what the search cannot see: odds, declared values that led
    it, a slanted seat, what may have `moved` it, an added mass that hangs elsewhere.
    """
    problem, ended = basis.problem, basis.ended
    plain, elsewhere = estimate_ratios(basis, at_bound), hung_elsewhere(problem, ended)
    ratios = {
        name: each.widened(elsewhere.get(name, 0.0), cause=DISTANCE)
        for name, each in widened_ratios(basis, plain, moved).items()
    }
    parameters = {
        name: each.widened(elsewhere[name], cause=DISTANCE)
        for name, each in estimate_leg(basis, ratios, at_bound).items()
    }
    inertia = moved.widen(parameters["inertia"], mean_of(basis, ["inertia"], set()).gradient)
    parameters["inertia"] = inertia
    grown = {name: growth(plain[name], each, inertia) for name, each in ratios.items()}
    for name in ("damping", "stiffness"):
        parameters[name] = parameters[name].widened(grown[f"{name}_over_inertia"])
    by_distance = elsewhere["inertia"] * (ratios[SWING].value or 0.0)
    return LegNumbers(ratios, parameters, grown[SWING], by_distance)


def widened_ratios(basis: Basis, plain: dict[str, Estimate], moved: Moved) -> dict[str, Estimate]:
    """The ratios, wider by odds, declared values that led the search, seat, and what `moved` it."""
    problem, ended = basis.problem, basis.ended
    odds, steps, beside = (of(problem, ended) for of in (at_odds, led_astray, slanted))

    def wider(name: str, each: Estimate) -> Estimate:
        gradient = mean_of(basis, problem.quantities_of(name), set()).gradient
        each = each.widened(steps.get(name, 0.0), least=odds.get(name, 0.0))
        return moved.widen(each.widened(beside.get(name, 0.0), cause="tilt"), gradient)

    return {name: wider(name, each) for name, each in plain.items()}


def estimate_leg(
    basis: Basis, ratios: dict[str, Estimate], at_bound: set[str]
) -> dict[str, Estimate]:
    """m, J, l, d, c; the last two go with J where motion tells no more than their ratio to it."""
    belief = basis.problem.belief
    parameters = {
        name: parameter_estimate(name, belief, mean_of(basis, [name], at_bound)) for name in NAMES
    }
    distance, mass = parameters["com_distance"], parameters["mass"]
    parameters["com_distance"] = goes_with_mass(distance, mass)
    for name in ("damping", "stiffness"):
        if name in basis.problem.absent:
            parameters[name] = none_of(label_of(parameters[name]))
            continue
        ratio = ratios[f"{name}_over_inertia"]
        parameters[name] = goes_with_scale(parameters[name], ratio, parameters["inertia"])
    return parameters


def growth(before: Estimate, after: Estimate, inertia: Estimate) -> float:
    """By how much the error of what is this ratio times J grows with that of the ratio."""
    errors = [each.standard_error or 0.0 for each in (before, after)]
    return (inertia.value or 0.0) * float(np.sqrt(max(errors[1] ** 2 - errors[0] ** 2, 0.0)))
