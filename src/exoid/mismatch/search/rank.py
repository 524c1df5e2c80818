"""Which candidate is better, and which a recording cannot tell apart."""

import numpy as np

from exoid.mismatch.evidence.yardstick import APART, Yardstick
from exoid.mismatch.screen.hypothesis import Optimum
from exoid.mismatch.search.found import best_of, size
from exoid.physics.parameter import declarations
from exoid.physics.term import SensorTerm, Term


def by_evidence(settled: list[Optimum], base: Optimum, measure: Yardstick) -> list[Optimum]:
    """The best first; of those that noise alone may tell apart, and of its own simpler forms that
    are alike, the simplest first.
    """
    known = best_of([one for one in settled if one.sound])
    known.sort(key=lambda one: measure.evidence(base.square, one.square, size(one)), reverse=True)

    def order(one: Optimum) -> float:
        best = known[0]
        gain = measure.evidence(one.square, best.square, size(best) - size(one))
        first = gain < APART or (simpler(one, best) and alike(one, best, measure))
        return float(size(one)) if first else np.inf

    return sorted(known, key=order)


def fewest(some: list[Optimum]) -> list[Optimum]:
    """The one with the fewest numbers, of several the best; none where there is none."""
    return sorted(some, key=lambda one: (size(one), one.square))[:1]


def simpler(one: Optimum, best: Optimum) -> bool:
    """Is the best but a richer form of it?"""
    pairs = list(zip(one.candidate.terms, best.candidate.terms, strict=False))
    same = len(one.candidate.terms) == len(best.candidate.terms)
    return same and all(few is many or simpler_form(few, many) for few, many in pairs)


def alike(one: Optimum, best: Optimum, measure: Yardstick, times: float = 1.0) -> bool:
    """Can noise, or what even the best does not explain, be all that tells them apart? So many
    `times` over they may have to be.
    """
    return measure.apart(one.square, best.square, size(best) - size(one)) < times * APART


def simpler_form(simple: type[Term], rich: type[Term]) -> bool:
    """Does the richer of two torques, or of two errors of sensors, hold all numbers of the simple
    one, by name and unit?
    """
    few, many = ({(name, each.unit) for name, each in declarations(of)} for of in (simple, rich))
    return few < many and issubclass(simple, SensorTerm) == issubclass(rich, SensorTerm)
