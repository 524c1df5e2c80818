"""Which terms explain the mismatch: all of them pinned, the best of them free, then in pairs."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from exoid.mismatch.evidence.measure import yardstick
from exoid.mismatch.evidence.yardstick import APART
from exoid.mismatch.screen.hypothesis import Hypothesis, Optimum
from exoid.mismatch.screen.optimise import (
    FEWER_ROUNDS,
    FLOOR,
    enough,
    given,
    hopped,
    polished,
    settle,
    settle_free,
    strikes,
)
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.mismatch.search.challenge import beside_play, with_hidden
from exoid.mismatch.search.exchange import exchanged
from exoid.mismatch.search.found import Found, best_of, lone_and_joint, size
from exoid.mismatch.search.likely import likeliest, ordered, shortlist
from exoid.mismatch.search.pairs import (
    beside_sticking,
    pairs,
    plainer_forms,
    plainer_pairs,
    plainer_sets,
)
from exoid.mismatch.search.race import simulated
from exoid.mismatch.search.rank import by_evidence, fewest
from exoid.mismatch.search.several import as_good, relatives, several, sticks, with_one_more
from exoid.mismatch.search.variants import (
    applies,
    in_simplest_form,
    nested,
    reduced,
    suspected_sensors,
    twins,
    unwatched,
    with_common,
)
from exoid.physics.term import Term

ROUNDS = 8  # of pinned steps; what is close by then is brought to its end running free
PAIR_ROUNDS = 6
STUCK = 2  # causes that stick, of which pairs run free; pairs of simple causes that do
FALSE = 0.5  # of the baseline's square, below which another valley makes it a false one

Told = Callable[[str], None]


def look(prepared: PreparedRecording, base: Optimum, told: Told) -> Found:
    """Every term by itself; pairs where no single one is enough. What explains best may show that
    the baseline lay in a false valley: then all begins again from the leg that it found.
    """
    begin = beginning(prepared, base)
    usable = [term for term in prepared.library if applies(prepared, term)]
    known = given(prepared, begin)
    told(f"testing {len(usable)} candidates together")
    starts = [
        begin.with_term(term, value, known) for term in usable for value in prepared.starts(term)
    ]
    first = best_of(settle(prepared, starts, rounds=ROUNDS))
    failed = [one.candidate.terms[-1] for one in first if not one.sound]
    ranked = ordered(first)
    told("simulating the best of them")
    likely = likeliest(prepared, shortlist(ranked))
    likely += unwatched(prepared, [one for one in ranked if one not in likely], base)
    singles = led_free(prepared, likely)
    singles += [*twins(prepared, singles, singles), *nested(prepared, singles, usable)]
    truer = truer_baseline(prepared, base, least(base, *singles))
    if truer is not None:
        return look(prepared, truer, told)
    measure = yardstick(prepared, least(base, *singles))
    singles = by_evidence(singles, base, measure)
    suspected = suspected_sensors(prepared, base, singles)
    sensors = [one for one in suspected if len(one.candidate.terms) > 1]
    alone = [one for one in suspected if len(one.candidate.terms) == 1]
    singles = by_evidence([*singles, *alone], base, measure)
    after = prepared.untethered(least(base, *singles).square)
    found = Found(after, base, begin, singles, sensors, ranked, failed, measure)
    return beyond_the_first(found, usable, told)


def beyond_the_first(found: Found, usable: list[type[Term]], told: Told) -> Found:
    """What acts in moments only, pairs, and sets. What strikes takes longest: it comes after pairs
    of everything else.
    """
    explained = found.yardstick.explains(least(found.base, *found.singles).square)
    if not explained:
        sticking = [one for one in found.pinned if not strikes(one.candidate)]
        found = with_hidden(found, sticking, told)
    found, sought = with_pairs(exchanged(found), usable, told, struck=explained)
    if not explained and (striking := strikes_in_reach(found)):
        found = beside_play(exchanged(with_hidden(found, striking, told)), usable, told)
        if not leaving_noise(found.pairs, found.prepared):
            found, sought = with_pairs(found, usable, told, struck=True)
    return with_sets(found, usable, told) if sought else found


def strikes_in_reach(found: Found) -> list[Optimum]:
    """What strikes; where a pair leaves only noise, none that needs so many numbers more that it
    cannot come near.
    """
    each = [one for one in found.pinned if strikes(one.candidate)]
    known = leaving_noise(found.pairs, found.prepared)
    if not known:
        return each
    few, measure = min(map(size, known)), yardstick(found.prepared, least(*known))
    return [one for one in each if measure.price(size(one) - few) < APART]


def leaving_noise(some: list[Optimum], prepared: PreparedRecording) -> list[Optimum]:
    """Those that leave only noise."""
    return [one for one in some if enough(prepared, one.square)]


def with_pairs(
    found: Found, usable: list[type[Term]], told: Told, *, struck: bool
) -> tuple[Found, bool]:
    """The same with the best pairs, running free, and whether there is anything to pair; with what
    strikes only where `struck`. A pair that ran before does not run again.
    """
    prepared, known = found.prepared, {frozenset(one.candidate.terms) for one in found.pairs}
    both, free = seconds(found, usable, told)
    if not both and not free:
        return replace(found, pairs=by_evidence(found.pairs, found.base, found.yardstick)), False
    told("simulating the best pairs")
    possible = [one for one in both if struck or not strikes(one.candidate)]
    fresh = [one for one in shortlist(possible) if frozenset(one.candidate.terms) not in known]
    joint = [*led_free(prepared, likeliest(prepared, fresh)), *found.pairs]
    alone = least(found.base, *found.singles)
    more = [one for one in free if frozenset(one.terms) not in known]
    joint += simulated(prepared, more, least(alone, *joint).square)
    return replace(found, pairs=joint, glimpsed=tuple(both)), True


def seconds(
    found: Found, usable: list[type[Term]], told: Told
) -> tuple[list[Optimum], list[Hypothesis]]:
    """Pairs along the motion, the best first, and such as run free anyhow. Where the best single
    cause is enough, only simple ones that explain as much; where it leaves hardly more than noise,
    a second one must be clear at first sight.
    """
    prepared, best = found.prepared, least(found.base, *found.singles)
    if best.square > FLOOR * prepared.samples:
        told("testing pairs")
        starts = pairs(prepared, found.pinned, found.singles)
        both = ordered(best_of(settle(prepared, starts, rounds=PAIR_ROUNDS)))
        stuck = [one for one in found.singles if sticks(one.candidate)][:STUCK]
        stuck = plainer_forms(found, stuck)
        return both, [each for one in stuck for each in beside_sticking(prepared, usable, one)]
    if enough(prepared, best.square):
        plain = settle(prepared, plainer_pairs(prepared, found.pinned, best), rounds=PAIR_ROUNDS)
        near = ordered(as_good(prepared, best, plain))[:STUCK]
        return [], [replace(one.candidate, linear=None) for one in near]
    if best.candidate.terms == prepared.common:
        return [], []
    told("testing a second cause")
    return [], with_one_more(prepared, usable, best)


def truer_baseline(prepared: PreparedRecording, base: Optimum, best: Optimum) -> Optimum | None:
    """The baseline in the valley of the best candidate, where its own is a false one."""
    if not best.square < FALSE * base.square:
        return None
    found = polished(prepared, with_common(prepared, best.candidate))
    return found if found.square < FALSE * base.square else None


def with_sets(found: Found, usable: list[type[Term]], told: Told) -> Found:
    """The same with sets where neither a cause nor a pair is enough, with what may act in the place
    of one cause of those that are, and with what remains of them where one is all it takes.
    """
    prepared, base, joint = found.prepared, found.base, [*found.pairs]
    alone = least(base, *found.singles)
    for best in ordered(joint)[:1]:
        plain = in_simplest_form(prepared, best, usable)
        joint.append(plain)
        clear = found.clear(alone, plain) or plain.square > FLOOR * prepared.samples
        if clear and not enough(prepared, min(alone.square, plain.square)):
            told("testing three causes and more")
            joint += several(prepared, usable, plain)
            joint += nested(prepared, ordered(joint)[:1], usable)
    for best in fewest(leaving_noise(joint, prepared)):
        plain = in_simplest_form(prepared, best, usable)
        plainer = plainer_sets(prepared, usable, plain)
        joint += [plain, *simulated(prepared, plainer, plain.square)]
    lone, joint = lone_and_joint(prepared, joint)
    single = [*found.singles, *lone, *reduced(prepared, ordered(joint)[:1])]
    singles = by_evidence(single, base, found.yardstick)
    singles += nested(prepared, singles, usable)
    joint += relatives(prepared, usable, joint, singles)
    measure = yardstick(prepared, least(base, *singles, *joint))
    joint = by_evidence(joint, base, measure)
    joint = [*(hopped(prepared, one) for one in joint[:1]), *joint[1:]]
    joint = by_evidence([*joint, *twins(prepared, joint[:1], joint)], base, measure)
    singles = by_evidence(singles, base, measure)
    return replace(found, singles=singles, pairs=joint, yardstick=measure)


def led_free(prepared: PreparedRecording, pinned: list[Optimum]) -> list[Optimum]:
    """Running free from where they came pinned, the best first."""
    rival = pinned[0].square if pinned else np.inf
    return simulated(prepared, [one.candidate for one in pinned], rival)


def beginning(prepared: PreparedRecording, base: Optimum) -> Hypothesis:
    """Where candidates begin: at the baseline, but with no zero that only a missing cause made."""
    at = base.candidate
    if abs(at.zero[1]) <= prepared.zero:
        return at
    declared = replace(prepared, zero=0.0)
    start = replace(at, zero=at.zero * [1.0, 0.0])
    return settle_free(declared, start, rounds=FEWER_ROUNDS).candidate


def least(*settled: Optimum) -> Optimum:
    """What leaves least."""
    return min(settled, key=lambda one: one.square if np.isfinite(one.square) else np.inf)
