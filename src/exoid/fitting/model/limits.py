"""What a leg and its terms can be, and what is expected of them, in numbers."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from jaxtyping import Float

from exoid.fitting.model.mounting import Mounting
from exoid.fitting.model.term_parameters import NAMES, leg_of, parameters_of, with_values
from exoid.fitting.model.user_values import DECLARED, ByHand
from exoid.physics.leg import LegParameters
from exoid.physics.record import record
from exoid.physics.term import Term

TORQUE = 250.0  # N m, of Eq. 13
NO_REACH = 1e3  # m: Eq. 12 and 13 have none; an infinite one marks a rig


@record
class Limits:
    """Bounds as in Eq. 13 and what holds for every rigid leg, m l^2 <= J <= reach m l.

    The left side is Eq. 12. The right side says that no part of the leg is farther from the knee
    than `reach`, so J = int r^2 dm <= reach int r dm. An infinite limit is no limit. Where the two
    ends of a bound are one, the parameter is fixed.
    """

    lower: LegParameters
    upper: LegParameters
    torque: Float[Any, ""]  # N m, greatest amplitude
    reach: Float[Any, ""]  # m
    lower_terms: tuple[Term, ...] = ()
    upper_terms: tuple[Term, ...] = ()


@record
class Prior:
    """Normal in the logarithms of m, l and J / (m l), and of d / J and c / J; or in own units.

    `whitening` is W with W'W the inverse covariance of the three, `knee` one over the standard
    deviation of the two; 0 says nothing. `own` are values in the parameters' own units, an infinite
    deviation says nothing.
    """

    centre: LegParameters
    whitening: Float[Any, "row 3"]
    knee: Float[Any, " 2"]
    own: LegParameters
    own_deviation: LegParameters
    weight: Float[Any, ""]  # lambda of Eq. 11
    mounting: Mounting | None = None  # standard deviations of what recordings own
    in_common: Mounting | None = None  # W of each, with W'W the inverse of its correlation
    terms: tuple[Term, ...] = ()  # what is expected of the terms' parameters
    terms_deviation: tuple[Term, ...] = ()  # an infinite one says nothing


def limits_of(ends: Mapping[str, tuple[float, float]], torque: float, furthest: float) -> Limits:
    """Of the lowest and the highest of each parameter of a leg."""
    return Limits(
        lower=leg_of(lambda name: ends[name][0]),
        upper=leg_of(lambda name: ends[name][1]),
        torque=np.asarray(torque),
        reach=np.asarray(furthest),
    )


def paper_limits() -> Limits:
    """Eq. 13, as `LegParameters` declares it."""
    ends = {name: (each.lower, each.upper) for name, each in DECLARED.items()}
    return limits_of(ends, TORQUE, NO_REACH)


def rig_limits() -> Limits:
    """Damping cannot be negative; nothing else is known of a rig."""
    ends = {**dict.fromkeys(NAMES, (-np.inf, np.inf)), "damping": (0.0, np.inf)}
    return limits_of(ends, np.inf, np.inf)


def limits_by_hand(limits: Limits, hand: ByHand) -> Limits:
    """The limits with the ends that were said; a fixed parameter has nothing between them."""
    lower, upper = dict(hand.fix), dict(hand.fix)
    for name, (low, high) in hand.bound.items():
        lower[name] = float(getattr(limits.lower, name)) if low is None else low
        upper[name] = float(getattr(limits.upper, name)) if high is None else high
        if lower[name] >= upper[name]:
            raise ValueError(
                f"bound of {name}: {lower[name]:g} to {upper[name]:g} leaves nothing, one end "
                "being what a leg of this body can have at most. Give both ends, or check the body."
            )
    lowest, highest = with_values(limits.lower, lower), with_values(limits.upper, upper)
    return replace(limits, lower=lowest, upper=highest)


def constraint_names(segments: int, terms: Sequence[type[Term]] = ()) -> list[str]:
    """Which parameter each entry of `constraint.violations_at` limits, or the rule it states."""
    torques = [f"torque_amplitude[{number}]" for number in range(segments)]
    rules = ["m l^2 <= J", "J <= reach m l"]
    of_terms = [name for name, _ in parameters_of(terms)]
    return [*NAMES, *NAMES, *rules, *torques, *torques, *of_terms, *of_terms]
