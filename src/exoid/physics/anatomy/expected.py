"""What is expected of a leg, as a type."""

from dataclasses import dataclass
from math import sqrt

Matrix = tuple[tuple[float, ...], ...]
STRANGE = 3.29  # standard deviations from what is expected: one leg in a thousand


@dataclass(frozen=True)
class Expected:
    """A value and its standard deviation between people, both in the unit of the parameter.

    The deviation is None where values spread over decades: `anatomy.knee` says how far.
    """

    value: float
    standard_deviation: float | None


@dataclass(frozen=True)
class ExpectedLeg:
    """What to expect of one leg before it has moved.

    `covariance` is of the logarithms of m, l and J / (m l); None where values are weighed one by
    one in their own units (Eq. 14).
    """

    mass: Expected  # kg, shank and foot
    inertia: Expected  # kg m^2, about the knee
    com_distance: Expected  # m, from the knee
    damping: Expected  # N m s/rad
    stiffness: Expected  # N m/rad
    source: str
    covariance: Matrix | None = None


def scattered(value: float, relative_variance: float) -> Expected:
    return Expected(value, sqrt(relative_variance) * value)
