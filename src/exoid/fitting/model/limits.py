"""What a leg and its terms can be, and what is expected of them, in numbers."""

from collections.abc import Sequence
from typing import Any

from jaxtyping import Float

from exoid.fitting.model.mounting import Mounting
from exoid.fitting.model.term_parameters import NAMES, parameters_of
from exoid.physics.leg import LegParameters
from exoid.physics.record import record
from exoid.physics.term import Term


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


def constraint_names(segments: int, terms: Sequence[type[Term]] = ()) -> list[str]:
    """Which parameter each entry of `constraint.violations_at` limits, or the rule it states."""
    torques = [f"torque_amplitude[{number}]" for number in range(segments)]
    rules = ["m l^2 <= J", "J <= reach m l"]
    of_terms = [name for name, _ in parameters_of(terms)]
    return [*NAMES, *NAMES, *rules, *torques, *torques, *of_terms, *of_terms]
