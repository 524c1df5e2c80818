"""Parameters of what is missing over an inertia that nobody knows."""

from dataclasses import replace
from math import hypot
from typing import Any

from exoid.fitting.model.term_parameters import RATIO_UNITS, parameters_of
from exoid.physics.library import library

OVER = "_over_inertia"


def guessed(fit: Any) -> bool:
    """Does nothing tell the inertia, so that every torque is off by one unknown factor?"""
    return fit.parameters["inertia"].value is None


def parameters_shown(found: Any, parameters: list[Any]) -> list[Any]:
    """Those of a diagnosis, over J, or times it, where they go with a J that nobody knows."""
    if not guessed(found.fit):
        return parameters
    return [over_inertia(each, found) for each in parameters]


def over_inertia(each: Any, found: Any) -> Any:
    """The ratio that the fit tells of a torque, else the torque over the inertia it was for."""
    known = {} if found.after is None else found.after.of_terms
    ratio = known.get(f"{each.name}{OVER}")
    if ratio is not None and ratio.value is not None:
        own = {"value": ratio.value, "standard_error": ratio.standard_error}
        return replace(each, name=f"{each.name} / J", unit=ratio.unit, **own)
    power = power_of(each)
    if not power:
        return each
    scale = found.inertia**-power
    error = None if each.standard_error is None else each.standard_error * scale
    sign, word = ("/", "per") if power > 0 else ("*", "times")
    unit = RATIO_UNITS.get(each.unit, f"{each.unit} {word} kg m^2")
    own = {"value": each.value * scale, "standard_error": error}
    return replace(each, name=f"{each.name} {sign} J", unit=unit, **own)


def power_of(each: Any) -> float:
    """1 of what grows with J, -1 of what falls with it, as a compliance does; else 0."""
    declared = dict(parameters_of(library())).get(each.name)
    return float(each.unit.startswith("N m") if declared is None else declared.inertia_power)


def times_inertia(each: Any, factor: float, doubt: float = 0.0) -> Any:
    """The parameter of a leg whose J is so many times as large; with an error that holds that of
    J, where this `doubt` is its share.
    """
    power, error = power_of(each), each.standard_error
    value = each.value * factor**power
    of_scale = abs(power * value) * doubt
    own = error and hypot(error * factor**power, of_scale)
    return replace(each, value=value, standard_error=own)


def doubt_of(inertia: Any) -> float:
    """What share of J its error is; 0 where nothing tells J, and what goes with it is for one."""
    return abs((inertia.standard_error or 0.0) / inertia.value) if inertia.value else 0.0
