"""The parameters of leg and terms as estimates, between their limits."""

from dataclasses import replace

import numpy as np

from exoid.fitting.model.belief import NAMES, Belief
from exoid.fitting.model.user_values import DECLARED
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.estimates.found import Found, why
from exoid.physics.parameter import Declaration


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
    if belief.by_hand.means(name) == "fix":
        return None, None
    if own is not None:
        value, deviation = own
    elif belief.expected is not None and name in NAMES:
        one = getattr(belief.expected, name)
        value, deviation = one.value, None if belief.raw else one.standard_deviation
    else:
        return None, None
    known = deviation is not None and weight > 0
    return value, deviation / np.sqrt(weight) if known else None
