"""Three and four causes at once, where no two of them explain what is missing."""

from dataclasses import replace

from exoid.mismatch.evidence.measure import yardstick
from exoid.mismatch.screen.hypothesis import Hypothesis, Optimum
from exoid.mismatch.screen.optimise import FLOOR, given, polished, settle
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.mismatch.search.found import best_of, size, sound
from exoid.physics.library import MOST_PARAMETERS
from exoid.physics.term import Term

MOST = 4  # causes of one recording
NEXT = 3  # further causes that run free beside those at hand
NEAR = 10.0  # mean square over the noise, of causes that one more may bring down to it
ROUNDS = 6  # of pinned steps


def several(prepared: PreparedRecording, usable: list[type[Term]], best: Optimum) -> list[Optimum]:
    """Sets with one cause more than the best at hand, and so on while that clearly explains more
    and noise is not reached.

    Of a set that explains all there is, those with one cause less are tried as well: is each of
    them needed?
    """
    found, measure = [], yardstick(prepared, best)
    most = MOST + len(prepared.common)
    while FLOOR < best.square / measure.samples < NEAR and len(best.candidate.terms) < most:
        starts = with_one_more(prepared, usable, best.candidate)
        wider = [one for each in starts if sound(one := polished(prepared, each))]
        better = min([best, *wider], key=lambda one: one.square)
        measure = yardstick(prepared, better)
        if not measure.clear(best.square, better.square, max(size(better) - size(best), 1)):
            break
        found += wider
        best = better
    if found and measure.explains(best.square):
        fewer = with_one_less(best.candidate, len(prepared.common))
        found += [polished(prepared, each) for each in fewer]
    return found


def with_one_more(
    prepared: PreparedRecording, usable: list[type[Term]], best: Hypothesis
) -> list[Hypothesis]:
    """The candidate with each of the causes that explain most beside those it has, pinned."""
    size = sum(value.size for value in best.values)
    if size > MOST_PARAMETERS:
        return []
    known = given(prepared, best)
    starts = [
        replace(best, terms=(*best.terms, term), values=(*best.values, value), linear=known)
        for term in usable
        for value in prepared.starts(term)
        if term not in best.terms
    ]
    wider = best_of([one for one in settle(prepared, starts, rounds=ROUNDS) if sound(one)])
    first = sorted(wider, key=lambda one: one.square)[:NEXT]
    return [replace(one.candidate, linear=None) for one in first]


def with_one_less(candidate: Hypothesis, first: int) -> list[Hypothesis]:
    """The candidate without each of its causes in turn, from the one in place `first` on."""
    return [
        replace(
            candidate,
            terms=candidate.terms[:out] + candidate.terms[out + 1 :],
            values=candidate.values[:out] + candidate.values[out + 1 :],
            linear=None,
        )
        for out in range(first, len(candidate.terms))
    ]
