"""The sure errors of sensors as terms of the answer, beside a baseline that has none of them.

Every candidate has them from the start (`PreparedRecording.common`). Here those that matter in the
best one become causes like others, with what no motion tells from them: only the encoder's gain
over the gyro's scale and the clock's rate is seen.
"""

from dataclasses import replace
from functools import partial

import numpy as np

from exoid.fitting.solve.cores.side_by_side import side_by_side
from exoid.mismatch.conclude.unneeded import without_unneeded
from exoid.mismatch.evidence.yardstick import UNEXPLAINED
from exoid.mismatch.screen.hypothesis import Hypothesis, Optimum
from exoid.mismatch.screen.optimise import settle_free
from exoid.mismatch.search.found import Found, best_of, size
from exoid.mismatch.search.race import left_of, simulated
from exoid.mismatch.search.rank import by_evidence
from exoid.mismatch.search.several import instead, with_one_more
from exoid.mismatch.search.variants import applies
from exoid.physics.parameter import declarations
from exoid.physics.sensing.clock_rate import ClockRate
from exoid.physics.sensing.encoder_gain import EncoderGain
from exoid.physics.sensing.gyro_scale import GyroScale
from exoid.physics.term import Term

KEPT = 0.5  # share of an error that must be left where only sensors make it


def with_faults_told(found: Found, best: Optimum) -> tuple[Found, Optimum]:
    """The same by a baseline without errors of sensors, and the best with those that matter."""
    prepared = found.prepared
    if not prepared.common:
        return found, best
    plain = found.base.candidate.without(prepared.common)
    base = settle_free(prepared, plain)
    rivals = [best, *without_contested(found, best)]
    best = max(rivals, key=found.evidence)
    best = without_unneeded(found, base, best, prepared.common)
    alike = others(found, best)
    simpler = [without_unneeded(found, base, one, one.candidate.terms) for one in alike]
    each = [found.base, *found.singles, *found.pairs, *rivals, *alike, *simpler]
    best = max([best, *(one for one in simpler if size(one) < size(best))], key=found.evidence)
    each = best_of([one for one in each if one.candidate.terms != best.candidate.terms])
    if best is not base:
        each.append(best)
    return told(found, base, each), best


def told(found: Found, base: Optimum, each: list[Optimum]) -> Found:
    """What was found, with the errors of sensors among the causes."""
    alone = [one for one in each if len(one.candidate.terms) == 1]
    joint = [one for one in each if len(one.candidate.terms) > 1]
    return replace(
        found,
        base=base,
        singles=by_evidence(alone, base, found.yardstick),
        pairs=by_evidence(joint, base, found.yardstick),
    )


def others(found: Found, best: Optimum) -> list[Optimum]:
    """The best with other errors of sensors that show about the same, and what is best beside them:
    a cause that was found beside one error may be none with another.
    """
    prepared, mine = found.prepared, best.candidate
    sets = [each for each in prepared.sensors.sure.alike if not {*each} & {*mine.terms}]
    common = [term for term in prepared.common if term in mine.terms]
    starts = [swapped(mine, common, each) for each in sets] if common else []
    if GyroScale in common:
        free = [one for one in (ClockRate, EncoderGain) if one not in mine.terms]
        starts += [in_place(mine, one) for one in free]
    ended = side_by_side(partial(settle_free, prepared), starts)
    causes = len(mine.terms) - len(common)
    ended += [one for each in sets for one in afresh(found, each, causes, best.square)]
    return [one for one in ended if one.square < UNEXPLAINED * max(best.square, 1.0)]


def afresh(
    found: Found, errors: tuple[type[Term], ...], causes: int, rival: float
) -> list[Optimum]:
    """These errors of sensors in the place of those that every candidate has, and beside them up
    to so many of the causes that explain most.
    """
    start = swapped(found.base.candidate, list(found.prepared.common), errors)
    prepared = replace(found.prepared, common=errors)
    usable = [each for each in prepared.library if applies(prepared, each)]
    ended = wider = [settle_free(prepared, start)]
    for _ in range(causes):
        near = with_one_more(prepared, usable, min(wider, key=left_of))
        wider = simulated(prepared, near, rival)
        if not wider:
            break
        ended = [*ended, *wider]
    return ended


def without_contested(found: Found, best: Optimum) -> list[Optimum]:
    """The best with another cause in the place of each error of which it has less than half as much
    as the sensors say among themselves: then the leg, too, makes them differ.
    """
    prepared, mine, rivals = found.prepared, best.candidate, []
    for error in prepared.sensors.sure.errors:
        term = error.fault.term
        if term in mine.terms and len(mine.terms) > 1:
            value = mine.values[mine.terms.index(term)]
            if (value * error.values < KEPT * error.values**2).any():
                rivals += instead(prepared, mine.without([term]), term, best.square)
    return rivals


def in_place(mine: Hypothesis, other: type[Term]) -> Hypothesis:
    """The candidate with a rate of the clock, or a gain of the encoder, for the gyro's scale."""
    place = mine.terms.index(GyroScale)
    terms, values = list(mine.terms), list(mine.values)
    terms[place], values[place] = other, 1 / (1 + mine.values[place]) - 1
    return replace(mine, terms=tuple(terms), values=tuple(values), linear=None)


def swapped(mine: Hypothesis, common: list[type[Term]], others: tuple[type[Term], ...]):
    """The candidate with other errors of sensors, from none of their own size."""
    kept = mine.without(common)
    values = [np.zeros(len(list(declarations(term)))) for term in others]
    return replace(kept, terms=(*others, *kept.terms), values=(*values, *kept.values))
