"""An encoder's zero that is farther off than is usual: no leg explains it, and it is worth a name.

Every candidate leaves the zero of the encoder free, as far as it usually is off
(`PreparedRecording.usual`). A zero that is clearly farther off is a cause like others: here it
becomes a term, beside a baseline that takes the zero as declared.
"""

from dataclasses import replace

import numpy as np

from exoid.mismatch.conclude.numbers import CERTAIN, covariance
from exoid.mismatch.screen.hypothesis import Hypothesis, Optimum
from exoid.mismatch.screen.optimise import settle_free
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.mismatch.screen.race import simulated
from exoid.mismatch.search.found import Found
from exoid.mismatch.search.rank import by_evidence
from exoid.mismatch.search.several import REACH, beside
from exoid.mismatch.search.variants import applies
from exoid.physics.sensing.angle_offset import AngleOffset

RIVALS = 4  # of the other causes, each with and without the zero
INSTEAD = 2  # causes that are tried in its place


def unusual(found: Found, best: Optimum) -> bool:
    """Is the zero certainly off, as the best explanation has it, and by more than is usual?"""
    usual = found.prepared.zero
    if usual == 0.0:  # it is known
        return False
    value, place = abs(float(best.candidate.zero[1])), best.candidate.point.size + 1
    variance = covariance(found, best)[place, place]
    return bool(value > usual and value**2 > CERTAIN**2 * variance)


def as_a_term(found: Found, best: Optimum) -> tuple[Found, Optimum]:
    """The zero as a term of the best and of its rivals, who are also tried without it, a baseline
    that has it as declared, and what else may bend the best's motion as a zero does.
    """
    declared = replace(found.prepared, zero=0.0)
    rivals = [one for one in (*found.singles, *found.pairs) if one is not best][:RIVALS]
    base, *plain = [
        settle_free(declared, without_zero(one.candidate)) for one in (found.base, *rivals)
    ]
    instead = in_its_place(declared, best)
    plain += instead
    named = [settle_free(declared, with_zero_told(one.candidate)) for one in (best, *rivals)]
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
    return new, max([named[0], *instead], key=new.evidence)


def in_its_place(declared: PreparedRecording, best: Optimum) -> list[Optimum]:
    """The best with another cause in the place of the zero, where that may leave as little."""
    others = [one for one in declared.library if applies(declared, one) and one is not AngleOffset]
    seen = beside(declared, others, without_zero(best.candidate))
    near = [one.candidate for one in seen if one.square < REACH * best.square][:INSTEAD]
    return simulated(declared, near, np.inf)


def without_zero(candidate: Hypothesis) -> Hypothesis:
    return replace(candidate, zero=np.array([candidate.zero[0], 0.0]), linear=None)


def with_zero_told(candidate: Hypothesis) -> Hypothesis:
    """The candidate with its zero as a term."""
    return without_zero(candidate).with_term(AngleOffset, candidate.zero[1:])
