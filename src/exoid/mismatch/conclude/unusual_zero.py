"""An encoder's zero that is farther off than is usual: no leg explains it, and it is worth a name.

Every candidate leaves the zero of the encoder free, as far as it usually is off
(`PreparedRecording.usual`). A zero that is clearly farther off is a cause like others: here it
becomes a term, beside a baseline that takes the zero as declared.
"""

from dataclasses import replace
from functools import partial

import numpy as np

from exoid.fitting.solve.cores.side_by_side import side_by_side
from exoid.mismatch.conclude.numbers import CERTAIN, covariance
from exoid.mismatch.conclude.unneeded import without_unneeded
from exoid.mismatch.screen.hypothesis import Hypothesis, Optimum
from exoid.mismatch.screen.optimise import settle_free
from exoid.mismatch.search.found import Found, size
from exoid.mismatch.search.race import left_of
from exoid.mismatch.search.rank import by_evidence
from exoid.mismatch.search.several import instead, without_one
from exoid.physics.sensing.angle_offset import AngleOffset

RIVALS = 4  # of the other causes, each with and without the zero


def unusual(found: Found, best: Optimum) -> bool:
    """Is the zero certainly off, as the best explanation has it, and by more than is usual?"""
    usual = found.prepared.zero
    if usual == 0.0:  # it is known
        return False
    value, place = abs(float(best.candidate.zero[1])), best.candidate.point.size + 1
    variance = covariance(found, best)[place, place]
    return bool(value > usual and value**2 > CERTAIN**2 * variance)


def odder(found: Found, best: Optimum) -> Optimum:
    """The best, or what explains more were its unusual zero a cause: that costs what any number
    does, though it be farther off than a zero that nothing explains may be.
    """
    odd = [one for one in (*found.singles, *found.pairs) if unusual(found, one)]
    return max([best, *odd], key=lambda one: as_told(found, one))


def as_told(found: Found, one: Optimum) -> float:
    """Its evidence were its zero a cause, where it is unusual."""
    if not unusual(found, one):
        return found.evidence(one)
    measure, paid = found.yardstick, (float(one.candidate.zero[1]) / found.prepared.zero) ** 2
    return measure.evidence(found.base.square, one.square - paid, size(one) + 1)


def as_a_term(found: Found, best: Optimum) -> tuple[Found, Optimum]:
    """The zero as a term of the best and of its rivals, who are also tried without it, a baseline
    that has it as declared, what else may bend a motion as a zero does, beside the best and beside
    what is as good and no less simple, and what the best of all these does not need.
    """
    declared = replace(found.prepared, zero=0.0)
    others = [one for one in (*found.singles, *found.pairs) if one is not best]
    rivals = sorted(others, key=found.evidence, reverse=True)[:RIVALS]
    starts = [without_zero(one.candidate) for one in (found.base, *rivals)]
    starts += [with_zero_told(one.candidate) for one in (best, *rivals)]
    base, *both = side_by_side(partial(settle_free, declared), starts)
    plain, named = both[: len(rivals)], both[len(rivals) :]
    simple = [one for one in rivals if size(one) <= size(best)]
    equal = [best, *(one for one in simple if not found.clear(one, best))]
    instead_of_it = [
        other
        for one in equal
        for other in instead(declared, without_zero(one.candidate), AngleOffset, best.square)
    ]
    first = [named[0], *instead_of_it]
    first += without_one(declared, min(first, key=left_of))
    plain += first[1:]
    told = replace(found, prepared=declared)
    fewer = with_fewer_errors(told, base, [first[0], *plain], min(first, key=left_of))
    first, plain = [*first, *fewer], [*plain, *fewer]
    alone = [one for one in (*named, *plain) if len(one.candidate.terms) == 1]
    joint = [one for one in (*named, *plain) if len(one.candidate.terms) > 1]
    measure = found.yardstick
    new = replace(
        found,
        prepared=declared,
        base=base,
        begin=base.candidate,
        singles=by_evidence(alone, base, measure),
        pairs=by_evidence(joint, base, measure),
    )
    return new, as_listed(new, max(first, key=new.evidence))


def as_listed(found: Found, one: Optimum) -> Optimum:
    """The same set of causes as it is among the candidates, where two ways led to it."""
    each = (*found.singles, *found.pairs)
    return next(
        (other for other in each if {*other.candidate.terms} == {*one.candidate.terms}), one
    )


def with_fewer_errors(
    found: Found, base: Optimum, some: list[Optimum], best: Optimum
) -> list[Optimum]:
    """Of those that are as good as the best the forms without the sensors' errors that only an
    unusual zero had made them need.
    """
    equal = [one for one in some if not found.clear(one, best)]
    forms = [without_unneeded(found, base, one, found.prepared.common) for one in equal]
    return [form for form, one in zip(forms, equal, strict=True) if size(form) < size(one)]


def without_zero(candidate: Hypothesis) -> Hypothesis:
    return replace(candidate, zero=np.array([candidate.zero[0], 0.0]), linear=None)


def with_zero_told(candidate: Hypothesis) -> Hypothesis:
    """The candidate with its zero as a term."""
    return without_zero(candidate).with_term(AngleOffset, candidate.zero[1:])
