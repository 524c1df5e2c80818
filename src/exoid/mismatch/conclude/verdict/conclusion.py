"""From what was found to what is said: verdict, names, numbers with errors, and advice."""

from dataclasses import replace

import numpy as np

from exoid.fitting.result.fit_result import FitResult
from exoid.mismatch.answer.diagnosis import Diagnosis, Finding, NovelTorque, Verdict
from exoid.mismatch.conclude.asserted import (
    certain_of,
    equivalents,
    has,
    weight,
)
from exoid.mismatch.conclude.choose import Chosen
from exoid.mismatch.conclude.false_alarm import by_chance
from exoid.mismatch.conclude.numbers import (
    FORMULA,
    booked,
    gyro_bias,
    leg_of,
    parameters_of,
    pinned,
    taken_in,
    weighed,
)
from exoid.mismatch.conclude.rivals import (
    advice,
    likely,
    suspects,
)
from exoid.mismatch.conclude.twins import named_alike
from exoid.mismatch.conclude.verdict.cannot_tell import chance, too_little
from exoid.mismatch.conclude.verdict.in_all import in_all
from exoid.mismatch.conclude.verdict.judge import Case, claimed_at_once, judge
from exoid.mismatch.conclude.verdict.past_threshold import with_threshold
from exoid.mismatch.evidence.location import Location
from exoid.mismatch.evidence.proof import proof
from exoid.mismatch.novel.formula import Formula
from exoid.mismatch.novel.nameless import NAMELESS
from exoid.mismatch.screen.hypothesis import Optimum
from exoid.mismatch.search.found import Found, Workings, names, size
from exoid.mismatch.search.resample import inclusion
from exoid.mismatch.sensors.agreement import BIAS
from exoid.physics.library import library
from exoid.physics.term import Term, name_of


def concluded(
    result: FitResult,
    found: Found,
    chosen: Chosen,
    formula: Formula | None,
    location: Location,
    seed: int,
) -> Diagnosis:
    """The verdict and everything that goes with it."""
    prepared, measure, best = found.prepared, found.yardstick, chosen.best
    shown = proof(prepared, chosen.before, chosen.after)
    bias = gyro_bias(best, measure)
    sure = tuple(term for term in best.candidate.terms if term in prepared.common)
    named = best.candidate.terms and not formula
    equal = equivalents(found, best) if named else []
    certain = certain_of(found, best) if named else sure
    repeated = included(found, certain, best, formula, seed)
    lucky = by_chance(found, best, seed)
    inertia = float(np.exp(leg_of(found, best).log_inertia))
    place = location.with_inertia(inertia)
    case = Case(result, found, best, formula, certain, equal, bias is not None, place)
    judged = judge(case, shown, repeated, lucky)
    verdict, then = judged.verdict, judged.then
    # Is all that speaks against it that other segments would ask for another set?
    unlike = chance(repeated, claimed_at_once(found, best))
    beside = bool(unlike) and verdict == "cannot_tell" and judged.reasons == unlike
    maybe = judged.unseen or ([] if then else likely(found))
    novel = verdict == "mismatch" and formula is not None
    biased = [BIAS] if bias is not None and verdict != "cannot_tell" else []
    selected = [*named_terms(found, best, certain), *biased]
    rivals = [*equal, *(one for one in maybe if one not in equal)]
    suspected = rivals if verdict == "cannot_tell" else equal if len(equal) > 1 else []
    return Diagnosis(
        verdict=verdict,
        reasons=judged.reasons,
        findings=findings(selected, best) if verdict == "mismatch" else [],
        ranking=ranked(found, selected, formula),
        equivalent=named_alike(prepared, equal) if verdict != "none" else [],
        novel=novel,
        formula=novel_torque(found, formula, best) if formula and novel else None,
        parameters=[*parameters_of(found, best, formula), *([bias] if bias else [])],
        inertia=inertia,
        booked=booked(found, found.base, best),
        location=place,
        proof=shown,
        baseline=weighed(found, found.base, best),
        best=replace(weighed(found, best, best), terms=[FORMULA] if formula else names(best)),
        singles=[weighed(found, one, best) for one in found.singles],
        pairs=[weighed(found, one, best) for one in found.pairs],
        pinned=pinned(found),
        excluded=[name_of(term) for term in found.failed],
        false_alarm_rate=lucky.rate,
        power=measure.power(found.base.square, best.square, max(size(best), 1)),
        inclusion=repeated,
        weight=weight(found, certain or best.candidate.terms) if named else None,
        sensors=prepared.sensors.errors,
        before=result,
        suspected=suspects(found, suspected, best),
        advice=then or advised(found, equal or maybe[:2], verdict, formula),
        but_ends=judged.but_ends,
        in_all=list(map(name_of, in_all(found, best, seed))) if named and beside else [],
        workings=Workings(found, best),
    )


def advised(
    found: Found, rivals: list[Optimum], verdict: Verdict, formula: Formula | None
) -> list[str]:
    """What to record next, where the recording showed enough to say so."""
    prepared = found.prepared
    if too_little(prepared):
        return []
    said = advice(rivals, verdict, formula, prepared.segments, moved=prepared.moved)
    return with_threshold(said, prepared, rivals)


def novel_torque(found: Found, formula: Formula, best: Optimum) -> NovelTorque:
    """The formula, and when it acts."""
    over = formula.over(float(np.exp(leg_of(found, best).log_inertia)))
    once = acting_once(found, formula, best)
    each = (formula.words, formula.explained, formula.known, once, over, formula.simple)
    return NovelTorque(*each)


def acting_once(found: Found, formula: Formula, best: Optimum) -> tuple[float, float] | None:
    """From when to when nearly all of it acts, where every segment has it once."""
    seen, moments = found.prepared.seen, []
    for number, shown in enumerate(np.asarray(best.motion)):
        last = int(np.flatnonzero(seen.angle_weight[number] + seen.velocity_weight[number])[-1])
        angle, velocity = shown[: last + 1].T
        moments.append(
            formula.moment_of(angle, velocity, np.asarray(seen.time)[number, : last + 1])
        )
    known = [each for each in moments if each is not None]
    if len(known) < len(moments):
        return None
    return min(first for first, _ in known), max(last for _, last in known)


def findings(selected: list[str], best: Optimum) -> list[Finding]:
    """What is missing in words: of the library, or of a user's own terms."""
    known = {name_of(term): term for term in (*library(), *best.candidate.terms)}
    terms = [(name, known[name]) for name in selected]
    return [Finding(name, one.title, one.explanation, one.reference) for name, one in terms]


def included(
    found: Found,
    certain: tuple[type[Term], ...],
    best: Optimum,
    formula: Formula | None,
    seed: int,
) -> float | None:
    """How often resampled segments ask for the same causes of the library, in this form or another
    one.
    """
    if best is found.base:
        return None
    if formula:
        return inclusion(found, [best], [found.base], seed)
    same, rivals = [best], [found.base]
    named = (one for one in (*found.singles, *found.pairs) if not {*one.candidate.terms} & NAMELESS)
    for one in named:
        holds = all(has(one, cause) for cause in certain or best.candidate.terms)
        (same if holds else rivals).append(one)
    return inclusion(found, same, rivals, seed)


def named_terms(found: Found, best: Optimum, certain: tuple[type[Term], ...]) -> list[str]:
    """What is certain by name, without what is part of another: a tilted thigh is one cause."""
    inside = taken_in(found, best)
    return [name for name in map(name_of, certain) if name not in inside]


def ranked(found: Found, selected: list[str], formula: Formula | None) -> list[str]:
    """Names, best first: what was selected, then every other single term by what it explains."""
    singles = [names(one)[0] for one in found.singles if names(one)]
    others = [names(one)[-1] for one in found.pinned]
    first = [] if formula else by_share(found, selected)
    return list(dict.fromkeys([*first, *singles, *others]))


def by_share(found: Found, selected: list[str]) -> list[str]:
    """Of two effects the one first that explains more by itself."""
    alone = {names(one)[-1]: one.square for one in found.pinned}
    return sorted(selected, key=lambda name: alone.get(name, np.inf))
