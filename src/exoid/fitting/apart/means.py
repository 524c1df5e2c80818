"""Means over the segments that tell a number: ratios, torques, the parameters of terms."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from exoid.fitting.apart.averaged import averaged
from exoid.fitting.model.term_parameters import ratio_name
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.fit_result import FitResult
from exoid.physics.parameter import declarations
from exoid.physics.term import Term, name_of


def mean_ratio(each: Sequence[Estimate], owner: Sequence[int]) -> Estimate:
    """The mean over the segments that tell it."""
    told = [(one, at) for one, at in zip(each, owner, strict=True) if one.value is not None]
    values = [one for one, _ in told]
    return averaged(values, [at for _, at in told]) if len(told) > 1 else [*values, *each][0]


def mean_torque(each: Sequence[Estimate | None], owner: Sequence[int]) -> Estimate | None:
    """The mean over the voluntary segments, where it is known of all of them."""
    there = [(one, at) for one, at in zip(each, owner, strict=True) if one is not None]
    values = [one for one, _ in there]
    if not values or any(one.value is None for one in values):
        return values[0] if values else None
    return averaged(values, [at for _, at in there])


def mean_term(
    term: type[Term], results: Sequence[FitResult], owner: Sequence[int], inertia: Estimate
) -> dict[str, Estimate]:
    """A term's parameters as means over the segments; what goes with J from its mean over J."""
    each = [result.terms[name_of(term)] for result in results]
    means = {
        name: averaged([one[name] for one in each], owner)
        if all(one[name].value is not None for one in each)
        else next(one[name] for one in each if one[name].value is None)
        for name in each[0]
    }
    for name, declared in declarations(term):
        if declared.inertia_power and means[name].value is not None:
            ratio = means[ratio_name(name, declared)]
            means[name] = scaled(means[name], ratio, inertia, declared.inertia_power)
    return means


def scaled(own: Estimate, ratio: Estimate, inertia: Estimate, power: int) -> Estimate:
    """ratio J^power with its error, where the prior tells J; the mean as it is where it does not.

    Fixed by hand, it stays where it is.
    """
    if own.by_hand == "fix" or inertia.value is None or ratio.value is None:
        return own
    scale = inertia.value**power
    of_inertia = power * ratio.value * (inertia.standard_error or 0.0) / inertia.value
    return replace(
        own,
        value=ratio.value * scale,
        standard_error=float(np.hypot(ratio.standard_error or 0.0, of_inertia) * abs(scale)),
    )
