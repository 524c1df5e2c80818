"""That a recording tells another mass or inertia than its body's tables expect."""

from collections.abc import Mapping, Sequence
from typing import Any, TypeAlias

import numpy as np

from exoid.physics.anatomy.expected import STRANGE

# Not the result's own types, which stand above: an estimate has value, standard_error, expected and
# so on, a segment kind and added_mass.
Estimates: TypeAlias = Mapping[str, Any]
Segments: TypeAlias = Sequence[Any]

SCALE = ("inertia", "mass")
POUND = 0.45359237  # kg
ORDINARY = 2.0  # standard deviations, within which 95 % of legs are


def of_scale(parameters: Estimates, segments: Segments) -> list[str]:
    """That J, or m, comes out as hardly any leg of this body has it, and what to check.

    No tables are asked where the user said the value, or what to expect of it.
    """
    far = [parameters[name] for name in SCALE if abs(away(parameters[name])) >= STRANGE]
    if not far:
        return []
    each = "; ".join(map(told, far))
    inputs = "".join(f"{one}, " for one in inputs_of(segments))
    pounds = in_pounds(parameters["inertia"], segments)
    return [
        f"{each}: fewer than one leg in a thousand are as far off. Check {inputs}body mass and "
        f"height, and that nothing else was on the leg.{pounds} All that is in N m goes with J; "
        "the ratios to it do not."
    ]


def away(each: Any, times: float = 1.0) -> float:
    """How far `times` a value is from what is expected, in standard deviations of logarithms, as
    legs scatter and the recording tells it; 0 where the recording alone does not tell it.
    """
    told_by_data = each.determined_by == "data" and each.by_hand is None
    if not told_by_data or not each.value or each.value < 0 or not each.expected_deviation:
        return 0.0
    scatter = each.expected_deviation / each.expected
    error = (each.standard_error or 0.0) / each.value
    return float(np.log(times * each.value / each.expected) / np.hypot(scatter, error))


def told(each: Any) -> str:
    """The value beside what is expected."""
    return (
        f"by this recording {each.symbol} = {each.value:.3g} {each.unit}, "
        f"{each.value / each.expected:.2g} times what anatomy expects of this body "
        f"({each.expected:.3g} ± {each.expected_deviation:.2g}), which is {abs(away(each)):.2g} "
        "standard deviations of its logarithm"
    )


def inputs_of(segments: Segments) -> list[str]:
    """What was said of the recording that sets the scale of all masses and torques."""
    masses = sorted({each.added_mass for each in segments if each.added_mass > 0})
    said = ", ".join(f"{each:.3g}" for each in masses)
    inputs = [f"the added mass ({said} kg) and its distance"] if masses else []
    measured = any(each.kind == "measured" for each in segments)
    return [*inputs, "unit and gain of the measured torque"] if measured else inputs


def in_pounds(inertia: Any, segments: Segments) -> str:
    """The question whether an added mass was weighed in pounds, where that makes the leg ordinary:
    J goes with the added mass.
    """
    masses = {each.added_mass for each in segments if each.added_mass > 0}
    measured = any(each.kind == "measured" for each in segments)
    if measured or len(masses) != 1 or away(inertia) < STRANGE:
        return ""
    if abs(away(inertia, POUND)) > ORDINARY:
        return ""
    (mass,) = masses
    return (
        f" Is {mass:.3g} kg in pounds? {POUND * mass:.3g} kg would give J = "
        f"{POUND * inertia.value:.3g} {inertia.unit}."
    )
