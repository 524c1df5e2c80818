"""Which terms explain the mismatch: all of them pinned, the best of them free, then in pairs."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from exoid.fitting.solve.side_by_side import side_by_side
from exoid.mismatch.evidence.measure import yardstick
from exoid.mismatch.evidence.yardstick import ALIKE, APART, FOLLOWED, Yardstick
from exoid.mismatch.screen.hypothesis import Hypothesis, Optimum
from exoid.mismatch.screen.optimise import (
    FEWER_ROUNDS,
    FLOOR,
    polished,
    settle,
    settle_free,
    strikes,
)
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.mismatch.screen.race import raced
from exoid.mismatch.search.found import Found, best_of, size, sound
from exoid.mismatch.search.several import several
from exoid.mismatch.search.variants import (
    nested,
    pairs,
    reduced,
    simpler_form,
    twins,
    with_sure_sensors,
)
from exoid.physics.term import Term

SHORT = 4  # candidates that run free, by what they explain pinned
REACH = 3.0  # times the best, within which running free may change the order
ROUNDS = 8  # of pinned steps; what is close by then is brought to its end running free
PAIR_ROUNDS = 6
FALSE = 0.5  # of the baseline's square, below which another valley makes it a false one

Told = Callable[[str], None]


def look(prepared: PreparedRecording, base: Optimum, told: Told) -> Found:
    """Every term by itself; pairs where no single one is enough. What explains best may show that
    the baseline lay in a false valley: then all begins again from the leg that it found.
    """
    begin = beginning(prepared, base)
    usable = [term for term in prepared.library if applies(prepared, term)]
    told(f"testing {len(usable)} candidates")
    starts = [
        replace(begin, terms=(term,), values=(value,))
        for term in usable
        for value in prepared.starts(term)
    ]
    first = best_of(settle(prepared, starts, rounds=ROUNDS))
    failed = [one.candidate.terms[0] for one in first if not sound(one)]
    ranked = ordered(first)
    told("simulating the best of them")
    singles = side_by_side(lambda one: polished(prepared, one.candidate), shortlist(ranked))
    singles += [*twins(prepared, singles, singles), *nested(prepared, singles, of_all(singles))]
    truer = truer_baseline(prepared, base, least(*singles))
    if truer is not None:
        return look(prepared, truer, told)
    measure = yardstick(prepared, least(base, *singles))
    singles = by_evidence(singles, base, measure)
    beside = with_sure_sensors(prepared, base, singles)
    sensors = [one for one in beside if len(one.candidate.terms) > 1]
    alone = [one for one in beside if len(one.candidate.terms) == 1]
    singles = by_evidence([*singles, *alone], base, measure)
    found = Found(prepared, base, begin, singles, sensors, ranked, failed, measure)
    found = with_others(found, starts, told)
    best = least(base, *found.singles).square
    return found if best < FLOOR * measure.samples else with_sets(found, usable, told)


def truer_baseline(prepared: PreparedRecording, base: Optimum, best: Optimum) -> Optimum | None:
    """The baseline in the valley of the best candidate, where its own is a false one."""
    if not best.square < FALSE * base.square:
        return None
    found = polished(prepared, replace(best.candidate, terms=(), values=()))
    return found if found.square < FALSE * base.square else None


def with_sets(found: Found, usable: list[type[Term]], told: Told) -> Found:
    """The same with pairs, with sets where no pair is enough, and with what remains of them where
    one cause of them is all it takes.
    """
    prepared, base = found.prepared, found.base
    told("testing pairs")
    seconds = pairs(prepared, found.pinned, found.singles)
    both = ordered(best_of(settle(prepared, seconds, rounds=PAIR_ROUNDS)))
    told("simulating the best pairs")
    joint = [*(polished(prepared, one.candidate) for one in shortlist(both)), *found.pairs]
    for best in ordered(joint)[:1]:
        if best.square > FLOOR * found.yardstick.samples:
            told("testing three causes and more")
            joint += several(prepared, usable, best)
            joint += nested(prepared, ordered(joint)[:1], usable)
    single = [*found.singles, *reduced(prepared, ordered(joint)[:1])]
    singles = by_evidence(single, base, found.yardstick)
    singles += nested(prepared, singles, of_all(singles))
    measure = yardstick(prepared, least(base, *singles, *joint))
    joint = by_evidence(joint, base, measure)
    joint = by_evidence([*joint, *twins(prepared, joint[:1], joint)], base, measure)
    singles = by_evidence(singles, base, measure)
    return replace(found, singles=singles, pairs=joint, yardstick=measure)


def with_others(found: Found, starts: list[Hypothesis], told: Told) -> Found:
    """The same with what no look along a motion shows, as what strikes, and then with everything
    else where the best explains too little; neither where the best reaches the noise.
    """
    prepared, base, measure = found.prepared, found.base, found.yardstick
    tried = {one.candidate.terms for one in found.singles}
    striking = [one for one in found.pinned if strikes(one.candidate)]
    untried = [one for one in found.pinned if one.candidate.terms not in tried]
    others = [one for one in untried if one not in striking]
    for some, enough in ((striking, np.inf), (others, FOLLOWED)):
        best = least(base, *found.singles)
        if best.square < FLOOR * measure.samples or found.followed(best) >= enough:
            break
        told("simulating the others")
        more = side_by_side(lambda one: simulated(prepared, base, one, starts), some)
        found = replace(found, singles=by_evidence([*found.singles, *more], base, measure))
    return found


def simulated(
    prepared: PreparedRecording, base: Optimum, one: Optimum, starts: list[Hypothesis]
) -> Optimum:
    """Running free from where it came pinned, or from all its `starts` where that led nowhere or
    may have: what acts for a few samples only, such as a stop, is not seen along a motion with
    noise, nor is a leg within the play of the frame that carries the sensors.
    """
    led = [one.candidate] if one.square < base.square else []
    if led and not strikes(one.candidate):
        return polished(prepared, one.candidate)
    own = [start for start in starts if start.terms == one.candidate.terms]
    return raced(prepared, [*led, *own])


def beginning(prepared: PreparedRecording, base: Optimum) -> Hypothesis:
    """Where candidates begin: at the baseline, but with no zero that only a missing cause made."""
    at = base.candidate
    if abs(at.zero[1]) <= prepared.zero:
        return at
    declared = replace(prepared, zero=0.0)
    start = replace(at, zero=at.zero * [1.0, 0.0])
    return settle_free(declared, start, rounds=FEWER_ROUNDS).candidate


def applies(prepared: PreparedRecording, term: type[Term]) -> bool:
    """Can it act here: a voluntary torque, or a gyro?"""
    if term.living and prepared.rig:
        return False
    if term.voluntary:
        return any(each.voluntary for each in prepared.problem.movements)
    if term.replaces in prepared.zeros:
        return False
    if term.everyday:
        return bool((prepared.seen.velocity_weight > 0).any())
    return True


def of_all(some: list[Optimum]) -> list[type[Term]]:
    """The terms of all of them, each once."""
    return list(dict.fromkeys(term for one in some for term in one.candidate.terms))


def least(*settled: Optimum) -> Optimum:
    """What leaves least."""
    return min(settled, key=lambda one: one.square if np.isfinite(one.square) else np.inf)


def ordered(settled: list[Optimum]) -> list[Optimum]:
    """The sound ones, by what they leave."""
    return sorted(filter(sound, settled), key=lambda one: one.square)


def shortlist(ranked: list[Optimum]) -> list[Optimum]:
    """Those of the best whose order may change running free. What is simpler than the best one is
    always among them: with more parameters a wrong cause comes near sooner.
    """
    first = ranked[:SHORT]
    return [
        one for one in first if one.square < REACH * first[0].square or size(one) < size(first[0])
    ]


def by_evidence(settled: list[Optimum], base: Optimum, measure: Yardstick) -> list[Optimum]:
    """The best first; of those that are alike, and of its own simpler forms that it hardly beats,
    the simplest first.
    """
    known = best_of(list(filter(sound, settled)))
    known.sort(key=lambda one: measure.evidence(base.square, one.square, size(one)), reverse=True)

    def order(one: Optimum) -> float:
        first = alike(one, known[0], measure) or in_its_place(one, known[0], measure)
        return float(size(one)) if first else np.inf

    return sorted(known, key=order)


def alike(one: Optimum, best: Optimum, measure: Yardstick) -> bool:
    """Can noise be all that tells a candidate from the best?"""
    if not measure.explains(best.square):
        return one.square < ALIKE * best.square
    return measure.evidence(one.square, best.square, size(best) - size(one)) < APART


def hardly_beaten(one: Optimum, best: Optimum, measure: Yardstick) -> bool:
    """Is the best better by less than even it leaves over the noise? What nobody explains may as
    well be what tells them apart.
    """
    return one.square - best.square < best.square - measure.samples


def in_its_place(one: Optimum, best: Optimum, measure: Yardstick) -> bool:
    """Is it hardly beaten, and the best but a richer form of it?"""
    pairs = list(zip(one.candidate.terms, best.candidate.terms, strict=False))
    same = len(one.candidate.terms) == len(best.candidate.terms)
    forms = all(simple is rich or simpler_form(simple, rich) for simple, rich in pairs)
    return same and forms and hardly_beaten(one, best, measure)


def equivalents(found: Found, best: Optimum) -> list[Optimum]:
    """The candidates that this recording cannot tell from the best, itself included."""
    rivals = found.pairs if len(best.candidate.terms) > 1 else found.singles
    top, measure = max(rivals, key=found.evidence), found.yardstick
    return [
        one
        for one in rivals
        if one is best or alike(one, top, measure) or hardly_beaten(one, top, measure)
    ]
