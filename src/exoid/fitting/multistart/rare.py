"""What recordings own together, is seldom wrong, but then by a lot; and what the data say of it.

A normal distribution of what is usual would bend the leg to such a recording. Where the data speak
clearly against it, the width of that recording's own distribution follows them (empirical Bayes).
"""

from dataclasses import dataclass

import numpy as np

from exoid.fitting.model.coordinates import TYPICAL, places
from exoid.fitting.model.systematics import sharing
from exoid.fitting.solve.ask import take
from exoid.fitting.solve.problem import Problem
from exoid.fitting.solve.program_values import Solved

VAGUE = 1e-9  # of every information, and of one typical step, that is known of everything


@dataclass(frozen=True)
class Rare:
    """What some recordings own together, and in this `share` of all cases is seldom as declared:
    then with this standard deviation, in its own unit.
    """

    name: str  # of a `Mounting`
    entries: list[int]  # recordings
    deviation: float
    share: float


@dataclass(frozen=True, eq=False)
class Seen:
    """A value, and the variance with which all but its prior tells it, in its unit."""

    value: float
    variance: float

    def likelihood(self, deviation: float) -> float:
        """The logarithm of its marginal likelihood under a prior of this standard deviation."""
        total = self.variance + deviation**2
        return -(np.log(total) + self.value**2 / total) / 2


def found(problem: Problem, at: Solved, row: int, one: Rare, total: np.ndarray) -> Seen:
    """What all but its own prior tells of it: what its recordings have in common.

    Of values with the prior covariance C, of which c is that with what they have in common, this is
    w = c C^-1 of them, and of the variance that it has w c is told by them.
    """
    place, unit = places_of(at, one.name, one.entries), unit_of(one)
    covariance = believed(problem, one)
    whole = covariance.min()
    weights = np.linalg.solve(covariance, np.full(len(one.entries), whole))
    inside = variances(total)[np.ix_(place, place)] * unit**2
    told = 1 / float(weights @ inside @ weights + whole * (1 - weights.sum()))
    alone = max(told - 1 / whole, 1e-9 * told)
    value = float(weights @ getattr(at.coordinates.mounting, one.name)[row, one.entries])
    return Seen(value * told / alone, 1 / alone)


def believed(problem: Problem, one: Rare) -> np.ndarray:
    """The covariance with which these are believed, in the square of their unit."""
    alike, deviation = problem.belief.prior.in_common, problem.deviation_of(one.name)[one.entries]
    assert alike is not None  # `pose` gives one
    own = getattr(alike, one.name)
    correlation = np.linalg.inv(own.T @ own)[np.ix_(one.entries, one.entries)]
    return correlation * np.outer(deviation, deviation)


def usual_of(problem: Problem, one: Rare) -> float:
    """Its standard deviation where it is as declared."""
    return float(problem.deviation_of(one.name)[one.entries[0]])


def unit_of(one: Rare) -> float:
    """That of its coordinate."""
    return float(getattr(TYPICAL.mounting, one.name))


def seats(problem: Problem) -> list[list[int]]:
    """The recordings of which no tilt is declared, in groups, each on one seat."""
    return together(problem, "tilt")


def together(problem: Problem, name: str, declared_as: str | None = None) -> list[list[int]]:
    """The recordings that do not declare this, in groups that have it in common."""
    alike, free = problem.belief.prior.in_common, undeclared(problem, name, declared_as or name)
    assert alike is not None  # `pose` gives one
    return [each for each in sharing(getattr(alike, name)) if each[0] in free]


def undeclared(problem: Problem, name: str, declared_as: str | None = None) -> list[int]:
    """The recordings of which this is an unknown that they do not declare."""
    first, own = [each[0] for each in problem.recordings], declared_as or name
    return [n for n in problem.estimated(name) if own not in first[n].systematics.declared]


def variances(information: np.ndarray) -> np.ndarray:
    """The covariance of what is told so much of, large where nothing is told."""
    return np.linalg.inv(information + VAGUE * np.diag(np.diag(information) + 1))


def places_of(at: Solved, name: str, entries: list[int]) -> list[int]:
    """Which coordinates these are."""
    return [place_of(at, name, entry) for entry in entries]


def place_of(at: Solved, name: str, entry: int) -> int:
    """Which coordinate this is."""
    return int(getattr(places(take(at.coordinates, 0)).mounting, name)[entry])
