"""What a search among candidates found."""

from dataclasses import dataclass

import numpy as np

from exoid.mismatch.evidence.yardstick import Yardstick
from exoid.mismatch.screen.effect import named
from exoid.mismatch.screen.hypothesis import Hypothesis, Optimum
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.physics.term import Term, name_of


@dataclass(frozen=True, eq=False)
class Found:
    """What a search found, best first; `pinned` are those of the first look, `glimpsed` the pairs
    of theirs that did not run free.
    """

    prepared: PreparedRecording
    base: Optimum
    begin: Hypothesis  # the baseline where candidates began
    singles: list[Optimum]  # running free
    pairs: list[Optimum]
    pinned: list[Optimum]
    failed: list[type[Term]]  # whose derivatives are not finite
    yardstick: Yardstick
    glimpsed: tuple[Optimum, ...] = ()

    def clear(self, worse: Optimum, better: Optimum) -> bool:
        parameters = size(better) - size(worse)
        return self.yardstick.clear(worse.square, better.square, max(parameters, 1))

    def followed(self, one: Optimum) -> float:
        """The share of the baseline's excess over the noise that it explains."""
        return self.yardstick.followed(self.base.square, one.square)

    def evidence(self, one: Optimum) -> float:
        return self.yardstick.evidence(self.base.square, one.square, size(one))


@dataclass(frozen=True, eq=False)
class Workings:
    """What a diagnosis rests on, for those who ask further: all candidates, and the best one."""

    found: Found
    best: Optimum


def size(one: Optimum) -> int:
    """How many parameters its terms have."""
    return sum(value.size for value in one.candidate.values)


def unscaled_covariance(prepared: PreparedRecording, one: Optimum) -> np.ndarray:
    """Of all unknowns, for the inertia that the fit took and independent noise; 0 of what is fixed
    or not told.
    """
    normal = one.products.total[:-1, :-1].copy()
    lower, upper = prepared.bounds(one.candidate)
    fixed = lower == upper
    fixed[prepared.numbers.shared.log_inertia] = True
    normal[fixed], normal[:, fixed] = 0.0, 0.0
    size_of = np.sqrt(np.diag(normal))
    unit = np.where(size_of > 0, size_of, 1.0)
    units = np.outer(unit, unit)
    return np.linalg.pinv(normal / units, hermitian=True) / units


def lost_at(prepared: PreparedRecording, one: Optimum, plain: dict[int, float]) -> float:
    """What more would be left were these of its unknowns at these values, to first order."""
    rows = list(plain)
    variance = unscaled_covariance(prepared, one)[np.ix_(rows, rows)]
    off = one.candidate.unknowns[rows] - list(plain.values())
    return float(off @ np.linalg.pinv(variance) @ off)


def blurred(prepared: PreparedRecording, one: Optimum, scale: float) -> list[type[Term]]:
    """Its terms that are not what they are called, or not within a standard error of each of their
    numbers, by a variance `scale` times that of the noise.
    """
    errors = np.sqrt(scale * np.diag(unscaled_covariance(prepared, one)))
    found, first = [], one.candidate.point.size + one.candidate.zero.size
    for term, value in zip(one.candidate.terms, one.candidate.values, strict=True):
        off = np.diag(errors[first : first + value.size])
        if not all(named(term, each).itself() for each in (value, *(value - off), *(value + off))):
            found.append(term)
        first += value.size
    return found


def best_of(settled: list[Optimum]) -> list[Optimum]:
    """Of all starts of the same set of terms the best."""
    best: dict[frozenset[type[Term]], Optimum] = {}
    for one in settled:
        terms = frozenset(one.candidate.terms)
        if terms not in best or not one.square >= best[terms].square:
            best[terms] = one
    return list(best.values())


def lone_and_joint(
    prepared: PreparedRecording, some: list[Optimum]
) -> tuple[list[Optimum], list[Optimum]]:
    """Those of one cause beside what the sensors surely say, and those of several."""
    one = len(prepared.common) + 1
    several = [len(each.candidate.terms) > one for each in some]
    lone = [each for each, more in zip(some, several, strict=True) if not more]
    return lone, [each for each, more in zip(some, several, strict=True) if more]


def names(one: Optimum) -> list[str]:
    return [name_of(term) for term in one.candidate.terms]


def causes(one: Optimum) -> int:
    """How many; what every gyro has some of, as a scale and a delay, counts as one or as none."""
    return max(1, sum(not term.everyday for term in one.candidate.terms))


def words(terms: list[str]) -> str:
    """Causes that act together, as a sentence has them."""
    return " + ".join(terms).replace("_", " ")
