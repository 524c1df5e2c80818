"""Three and four causes at once, where no two of them explain what is missing."""

from collections.abc import Sequence
from dataclasses import replace

from exoid.mismatch.evidence.measure import yardstick
from exoid.mismatch.screen.hypothesis import Hypothesis, Optimum
from exoid.mismatch.screen.optimise import FLOOR, enough, given, settle
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.mismatch.search.found import size
from exoid.mismatch.search.glance import beside_free, nearest
from exoid.mismatch.search.likely import REACH, WORSE, likeliest, ordered, smeared
from exoid.mismatch.search.race import simulated
from exoid.mismatch.search.variants import applies, in_simplest_form
from exoid.physics.term import Term, busy

MOST = 4  # causes of one recording
PAIR = 2  # causes
OTHERS = 2  # causes that are tried in the place of one
NEXT = 3  # further causes that run free beside those at hand
NEAREST = 6  # further causes that are looked at beyond the first order
ROUNDS = 6  # of pinned steps


def several(prepared: PreparedRecording, usable: list[type[Term]], best: Optimum) -> list[Optimum]:
    """Sets with one cause more than the best at hand, and so on while that clearly explains more
    and noise is not reached; then with another cause in the place of one; each in its simplest
    form. What explains as much with another cause, or with one less, is found, too.
    """
    prepared = prepared.untethered(best.square)
    found, measure = [], yardstick(prepared, best)
    for steps in (with_one_more, with_another):
        while not enough(prepared, best.square):
            wider = simulated(prepared, steps(prepared, usable, best), best.square)
            better = min([best, *wider], key=lambda one: one.square)
            measure = yardstick(prepared, better)
            if not measure.clear(best.square, better.square, max(size(better) - size(best), 1)):
                break
            best = in_simplest_form(prepared, better, usable)
            found += [*wider, best]
    if not found:
        return []
    rivals = simulated(prepared, with_another(prepared, usable, best), best.square)
    return [*found, *rivals, *without_one(prepared, best)]


def relatives(
    prepared: PreparedRecording,
    usable: list[type[Term]],
    joint: list[Optimum],
    known: Sequence[Optimum],
) -> list[Optimum]:
    """Pairs with another cause in the place of one of the best, where that leaves only noise: what
    was not asked is not refuted. Of more causes at once `several` asked them.
    """
    best = min(joint, key=lambda one: one.square, default=None)
    pair = best is not None and len(best.candidate.terms) == PAIR + len(prepared.common)
    if best is None or not pair or not enough(prepared, best.square):
        return []
    done = {frozenset(one.candidate.terms) for one in joint}
    others = with_another(prepared, usable, best, known)
    fresh = [one for one in others if frozenset(one.terms) not in done]
    return simulated(prepared, fresh, best.square)


def without_one(prepared: PreparedRecording, best: Optimum) -> list[Optimum]:
    """The set without each of its causes in turn, where that may do as well."""
    fewer = with_one_less(best.candidate, len(prepared.common))
    seen = settle(prepared, fewer, rounds=ROUNDS)
    most = REACH * along_the_motion(prepared, best)
    near = [one.candidate for one in seen if one.square < most]
    return simulated(prepared, near, best.square)


def as_good(prepared: PreparedRecording, best: Optimum, some: list[Optimum]) -> list[Optimum]:
    """Those that leave along the motion no more than the best does there, but for noise."""
    if not some:
        return []
    most = along_the_motion(prepared, best) + WORSE * prepared.samples
    return [one for one in some if one.square < most]


def along_the_motion(prepared: PreparedRecording, best: Optimum) -> float:
    """What the best leaves along the motion, by which others are measured there, or free."""
    (seen,) = settle(prepared, [best.candidate], rounds=ROUNDS)
    return max(best.square, seen.square)


def with_one_more(
    prepared: PreparedRecording, usable: list[type[Term]], best: Optimum
) -> list[Hypothesis]:
    """The set with each of the causes that explain most beside those it has."""
    if len(best.candidate.terms) >= MOST + len(prepared.common):
        return []
    if sticks(best.candidate):
        measure = yardstick(prepared, best)
        near = beside_free(prepared, usable, best)
        more = [(left, one, one.unknowns.size - best.candidate.unknowns.size) for left, one in near]
        return [one for left, one, n in more if measure.clear(best.square, left, n)][:NEXT]
    first = more_than(prepared, best, beside(prepared, usable, best.candidate))[:NEXT]
    return [one.candidate for one in likeliest(prepared, first)]


def sticks(candidate: Hypothesis) -> bool:
    """Is it smeared along a motion, and simulated soon enough?"""
    return smeared(candidate) and not any(map(busy, candidate.terms))


def more_than(prepared: PreparedRecording, best: Optimum, wider: list[Optimum]) -> list[Optimum]:
    """Those sets of which it is clear at first sight that they explain more than the best."""
    measure, seen = yardstick(prepared, best), along_the_motion(prepared, best)
    return [one for one in wider if measure.clear(seen, one.square, max(size(one) - size(best), 1))]


def with_another(
    prepared: PreparedRecording,
    usable: list[type[Term]],
    best: Optimum,
    known: Sequence[Optimum] = (),
) -> list[Hypothesis]:
    """The set with another cause in the place of one, where that may leave as little; from where a
    set without that one is `known` to end.
    """
    common, ended = len(prepared.common), {one.candidate.terms: one.candidate for one in known}
    less = [ended.get(one.terms, one) for one in with_one_less(best.candidate, common)]
    seen = [
        beside(prepared, [each for each in usable if each is not out], fewer)[:OTHERS]
        for out, fewer in zip(best.candidate.terms[common:], less, strict=True)
    ]
    little = max(along_the_motion(prepared, best), FLOOR * prepared.samples)
    near = ordered([one for each in seen for one in each if one.square < little])[:MOST]
    return [one.candidate for one in likeliest(prepared, near)]


def instead(
    prepared: PreparedRecording, fewer: Hypothesis, out: type[Term], rival: float
) -> list[Optimum]:
    """The set `fewer`, and with one of the causes that explain most beside it, in the place of one
    that is `out`, running free as far as they come near what a rival leaves.

    Along a motion what is left may be far from its place without that one.
    """
    usable = [each for each in prepared.library if applies(prepared, each) and each is not out]
    seen = beside(prepared, usable, fewer)[:NEXT]
    plain = [fewer] if fewer.terms else []
    return simulated(prepared, [*plain, *(one.candidate for one in seen)], rival)


def beside(
    prepared: PreparedRecording, usable: list[type[Term]], known: Hypothesis
) -> list[Optimum]:
    """The best sets with one cause more, pinned, the best first."""
    effect = given(prepared, known)
    starts = [
        known.with_term(term, value, effect)
        for term in usable
        for value in prepared.starts(term)
        if term not in known.terms
    ]
    near = nearest(prepared, starts, NEAREST)
    wider = ordered(settle(prepared, near, rounds=ROUNDS))
    return [replace(one, candidate=replace(one.candidate, linear=None)) for one in wider]


def with_one_less(candidate: Hypothesis, first: int) -> list[Hypothesis]:
    """The candidate without each of its causes in turn, from the one in place `first` on."""
    return [candidate.without([term]) for term in candidate.terms[first:]]
