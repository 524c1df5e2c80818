"""Three and four causes at once, where no two of them explain what is missing."""

from dataclasses import replace

from exoid.mismatch.evidence.measure import yardstick
from exoid.mismatch.screen.hypothesis import Hypothesis, Linear, Optimum
from exoid.mismatch.screen.many_pinned import linear, together
from exoid.mismatch.screen.measured_motion import MeasuredMotion
from exoid.mismatch.screen.optimise import FLOOR, polished, settle
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.mismatch.search.found import best_of, size, sound
from exoid.physics.library import MOST_PARAMETERS
from exoid.physics.term import Term

MOST = 4  # causes of one recording
NEXT = 3  # further causes that run free beside those at hand
ROUNDS = 6  # of pinned steps
SLOTS = 2  # causes that the pinned program works out at once
REACH = 3.0  # times what the set leaves, within which running free may change the order


def several(prepared: PreparedRecording, usable: list[type[Term]], best: Optimum) -> list[Optimum]:
    """Sets with one cause more than the best at hand, and so on while that clearly explains more
    and noise is not reached.

    Those with one cause less are tried as well: is each of them needed?
    """
    found, measure = [], yardstick(prepared, best)
    while best.square > FLOOR * measure.samples and len(best.candidate.terms) < MOST:
        starts = with_one_more(prepared, usable, best.candidate)
        wider = [one for each in starts if sound(one := polished(prepared, each, best.square))]
        better = min([best, *wider], key=lambda one: one.square)
        measure = yardstick(prepared, better)
        if not measure.clear(best.square, better.square, max(size(better) - size(best), 1)):
            break
        found += wider
        best = better
    return [*found, *without_one(prepared, best)] if found else []


def without_one(prepared: PreparedRecording, best: Optimum) -> list[Optimum]:
    """The set without each of its causes in turn, where that may do as well."""
    fewer = with_one_less(best.candidate)
    if len(fewer) > SLOTS + 1:
        return [polished(prepared, each, best.square) for each in fewer]
    seen = settle(prepared, fewer, rounds=ROUNDS)
    near = [one.candidate for one in seen if one.square < REACH * best.square]
    return [polished(prepared, each, best.square) for each in near]


def with_one_more(
    prepared: PreparedRecording, usable: list[type[Term]], best: Hypothesis
) -> list[Hypothesis]:
    """The candidate with each of the causes that explain most beside those it has, pinned."""
    size = sum(value.size for value in best.values)
    if size > MOST_PARAMETERS:
        return []
    known = as_one(prepared, best, prepared.measured_motion)
    motion = settle(prepared, [replace(best, linear=known)], rounds=1)[0].motion
    known = as_one(prepared, best, motion)
    starts = [
        replace(best, terms=(*best.terms, term), values=(*best.values, value), linear=known)
        for term in usable
        for value in prepared.starts(term)
        if term not in best.terms
    ]
    wider = best_of([one for one in settle(prepared, starts, rounds=ROUNDS) if sound(one)])
    first = sorted(wider, key=lambda one: one.square)[:NEXT]
    return [replace(one.candidate, linear=None) for one in first]


def as_one(prepared: PreparedRecording, best: Hypothesis, motion: MeasuredMotion) -> Linear:
    """What all its terms do along a motion; the pinned program itself takes no more than two."""
    each = [
        (replace(best, terms=(term,), values=(value,), linear=None), motion)
        for term, value in zip(best.terms, best.values, strict=True)
    ]
    return together(linear(prepared, each))


def with_one_less(candidate: Hypothesis) -> list[Hypothesis]:
    """The candidate without each of its causes in turn."""
    return [
        replace(
            candidate,
            terms=candidate.terms[:out] + candidate.terms[out + 1 :],
            values=candidate.values[:out] + candidate.values[out + 1 :],
            linear=None,
        )
        for out in range(len(candidate.terms))
    ]
