"""Pairs of causes: the best single ones, each with what explains most beside it."""

from exoid.mismatch.screen.along_motion import linear
from exoid.mismatch.screen.hypothesis import Hypothesis, Optimum
from exoid.mismatch.screen.optimise import enough, settle_free, strikes
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.mismatch.search.found import Found
from exoid.mismatch.search.glance import beside_free, nearest
from exoid.mismatch.search.likely import foremost
from exoid.mismatch.search.rank import simpler
from exoid.physics.parameter import declarations
from exoid.physics.term import Term

PAIRED = 3  # first terms of a pair
SECONDS = 8  # second ones of each that are looked at beyond the first order
PLAIN = 3  # the same of causes with one parameter
SLIDING = 2  # second ones beside what sticks, that run free
FEW = 2  # parameters of a cause; one with more explains what several simple ones do


def pairs(
    prepared: PreparedRecording, ranked: list[Optimum], singles: list[Optimum]
) -> list[Hypothesis]:
    """The best single terms, each with those others that explain most beside it.

    Those that ran free come first as they ended there. What strikes is no first but where it is the
    best: pinned it takes the place of much else.
    """
    refined = {one.candidate.terms: one for one in singles}
    place = {terms: number for number, terms in enumerate(refined)}

    def order(one: Optimum) -> int:
        return place.get(one.candidate.terms, len(place))

    usable = [one for one in ranked if order(one) == 0 or not strikes(one.candidate)]
    best = sorted(usable, key=order)[:PAIRED]
    firsts = [refined.get(one.candidate.terms, one).candidate for one in best]
    motions = [one.motion for one in best]
    found = linear(prepared, list(zip(firsts, motions, strict=True)))
    made = []
    for number, (first, known) in enumerate(zip(firsts, found, strict=True)):
        done = {one.terms[-1] for one in firsts[: number + 1]}
        starts = [
            first.with_term(second.candidate.terms[-1], value, known)
            for second in ranked
            for value in prepared.starts(second.candidate.terms[-1])
            if second.candidate.terms[-1] not in done
        ]
        made += nearest(prepared, starts, SECONDS)
    return made


def plainer_forms(found: Found, some: list[Optimum]) -> list[Optimum]:
    """Without those that are but a richer form of another one and hardly better."""

    def needed(one: Optimum) -> bool:
        forms = [each for each in some if each is not one and simpler(each, one)]
        return all(found.clear(each, one) for each in forms)

    return [one for one in some if needed(one)]


def beside_sticking(
    prepared: PreparedRecording, usable: list[type[Term]], known: Optimum
) -> list[Hypothesis]:
    """What sticks, running free, with those second causes that to first order explain most beside
    it. A spring's rest angle has one number, and comes behind springs that bend.
    """
    seen = beside_free(prepared, usable, known)
    left, numbers = [one for one, _ in seen], [one.values[-1].size for _, one in seen]
    return [seen[each][1] for each in foremost(left, numbers, SLIDING)]


def plainer_pairs(
    prepared: PreparedRecording, ranked: list[Optimum], best: Optimum
) -> list[Hypothesis]:
    """Pairs of causes with one parameter each, where the best single cause has more than two: what
    one with many explains, two simple ones may explain as well.
    """
    if best.candidate.terms == prepared.common or best.candidate.values[-1].size <= FEW:
        return []
    plain = [one for one in ranked if one.candidate.values[-1].size == 1]
    made = []
    for number, one in enumerate(plain[:PAIRED]):
        (known,) = linear(prepared, [(one.candidate, one.motion)])
        starts = [
            one.candidate.with_term(second.candidate.terms[-1], value, known)
            for second in plain[number + 1 :]
            for value in prepared.starts(second.candidate.terms[-1])
        ]
        made += nearest(prepared, starts, PLAIN)
    return made


def plainer_sets(
    prepared: PreparedRecording, usable: list[type[Term]], best: Optimum
) -> list[Hypothesis]:
    """Where a set leaves only noise, others, in which causes with one parameter take the place of
    one with more than two: these may explain as much, and are the likelier.
    """
    if not enough(prepared, best.square):
        return []
    each = zip(best.candidate.terms, best.candidate.values, strict=True)
    rich = [term for term, value in each if value.size > FEW]
    plain = [term for term in usable if len([*declarations(term)]) == 1]
    made = []
    for term in rich:
        fewer = settle_free(prepared, best.candidate.without([term]))
        made += [start for _, start in beside_free(prepared, plain, fewer)[:PLAIN]]
    return made
