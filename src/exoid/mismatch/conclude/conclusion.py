"""From what was found to what is said: verdict, names, numbers with errors, and advice."""

from dataclasses import replace

import numpy as np

from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.result.remarks.anatomy_remarks import at_rate, unlike_anatomy
from exoid.mismatch.answer.diagnosis import Diagnosis, Finding, NovelTorque, Verdict
from exoid.mismatch.conclude.asserted import (
    certain_of,
    equivalents,
    has,
    stand_ins,
    weight,
    with_one_less,
)
from exoid.mismatch.conclude.cannot_tell import (
    broken,
    chance,
    faint,
    filtered_away,
    hands,
    luck,
    once,
    too_little,
    unrelaxed,
    unsure,
    vague,
)
from exoid.mismatch.conclude.choose import Chosen
from exoid.mismatch.conclude.false_alarm import Chance, by_chance
from exoid.mismatch.conclude.numbers import (
    CERTAIN,
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
    SUSPECTS,
    advice,
    hidden,
    likely,
    of_hidden,
    suspects,
    words,
)
from exoid.mismatch.conclude.twins import named_alike
from exoid.mismatch.evidence.location import Location
from exoid.mismatch.evidence.prediction import Proof
from exoid.mismatch.evidence.proof import proof
from exoid.mismatch.evidence.yardstick import FOLLOWED
from exoid.mismatch.novel.formula import Formula
from exoid.mismatch.novel.nameless import NAMELESS
from exoid.mismatch.screen.hypothesis import Optimum
from exoid.mismatch.screen.prepared_recording import PreparedRecording
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
    verdict, reasons = judge(found, best, shown, repeated, lucky)
    unseen = hidden(found, result) if verdict == "none" else []
    if unseen:
        verdict, reasons = "cannot_tell", [of_hidden(found, result, unseen[0])]
    if verdict == "mismatch" and formula is None and not certain:
        verdict, reasons = "cannot_tell", undecided(found, equal)
    biased = [BIAS] if bias is not None and verdict != "cannot_tell" else []
    verdict = "mismatch" if biased else verdict
    if verdict == "none":
        reasons = [*of_zeros(result, prepared), *of_what_hides(result)]
    maybe = unseen or likely(found)
    left = not explains_it(found, best) or formula
    doubts = []
    if left:
        doubts = (
            once(prepared, best)
            or unrelaxed(prepared, best)
            or vague(formula, guess_of(result, found, best))
        )
        doubts = doubts or filtered_away(prepared, formula)
    if verdict == "mismatch" and doubts:
        verdict, reasons = "cannot_tell", doubts
    novel = verdict == "mismatch" and formula is not None
    selected = [*named_terms(found, best, certain), *biased]
    suspected = maybe if verdict == "cannot_tell" else equal if len(equal) > 1 else []
    return Diagnosis(
        verdict=verdict,
        reasons=reasons,
        findings=findings(selected, best) if verdict == "mismatch" else [],
        ranking=ranked(found, selected, formula),
        equivalent=named_alike(prepared, equal) if verdict != "none" else [],
        novel=novel,
        formula=novel_torque(found, formula, best) if formula and novel else None,
        parameters=[*parameters_of(found, best, formula), *([bias] if bias else [])],
        inertia=float(np.exp(leg_of(found, best).log_inertia)),
        booked=booked(found, found.base, best),
        location=location,
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
        advice=[] if too_little(prepared) else advice(equal or maybe[:2], verdict, formula),
        workings=Workings(found, best),
    )


def guess_of(result: FitResult, found: Found, best: Optimum) -> float | None:
    """The inertia that the search took, where nothing tells one [kg m^2]."""
    told = result.parameters["inertia"].value is not None
    return None if told else float(np.exp(leg_of(found, best).log_inertia))


def novel_torque(found: Found, formula: Formula, best: Optimum) -> NovelTorque:
    """The formula, and when it acts where one motion has it once."""
    once = None
    if found.prepared.segments == 1:
        angle, velocity = np.asarray(best.motion)[0].T
        once = formula.moment_of(angle, velocity, np.asarray(found.prepared.seen.time)[0])
    over = formula.over(float(np.exp(leg_of(found, best).log_inertia)))
    return NovelTorque(formula.words, formula.explained, formula.known, once, over)


def of_zeros(result: FitResult, prepared: PreparedRecording) -> list[str]:
    """What to say of zeros of encoders that are certainly off, and no cause of anything."""
    usual = {each.source: each.systematics.zero for each in prepared.problem.movements}
    said = []
    for each in result.mountings:
        value, error = (each.zero.value, each.zero.standard_error) if each.zero else (None, None)
        if value is None or error is None or abs(value) < CERTAIN * error:
            continue
        whose = f" in {each.recording}" if len(result.mountings) > 1 else ""
        more = "more" if abs(value) > usual[each.recording] else "no more"
        said.append(
            f"the encoder's zero{whose} is off by {np.degrees(value):.2g} deg, {more} than is "
            "to be expected; the fit estimates it"
        )
    return said


def of_what_hides(result: FitResult) -> list[str]:
    """What a leg that is like no other may hide within the noise."""
    basis = result.basis
    assert basis is not None  # a joint fit has one
    belief = basis.problem.belief
    gravity = float(basis.ended.best.coordinates.shared.gravity[0])
    return [
        f"{each}: a spring with another rest angle, an encoder's zero, a mass that nobody declared "
        f"or {at_rate(belief, gravity)} would look like this, and hide in it"
        for each in unlike_anatomy(belief, gravity)
    ]


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


def judge(
    found: Found, best: Optimum, shown: Proof, repeated: float | None, lucky: Chance
) -> tuple[Verdict, list[str]]:
    """None, mismatch, or an honest doubt."""
    prepared = found.prepared
    little = [*too_little(prepared), *broken(prepared)]
    if best is found.base:
        left = found.base.square / found.yardstick.samples
        if little:
            return "cannot_tell", little
        if not found.yardstick.explains(found.base.square):
            return "cannot_tell", once(prepared, best) or [
                f"simulation and recording differ by {left**0.5:.2g} times the noise, but no cause "
                "explains it clearly better than another"
            ]
        doubts = hands(prepared)
        return ("cannot_tell", doubts) if doubts else ("none", [])
    explained = explains_it(found, best)
    doubts = [
        *little,
        *unsure(prepared, best, shown, explained=explained),
        *faint(found.base.square / found.yardstick.samples, claimed_at_once(found, best)),
        *chance(repeated),
        *luck(lucky),
    ]
    return ("cannot_tell", doubts) if doubts else ("mismatch", [])


def claimed_at_once(found: Found, best: Optimum) -> int:
    """How many causes it has that the sensors do not surely tell by themselves; a tilted thigh is
    one.
    """
    sure = (*found.prepared.common, *(term for term in best.candidate.terms if term.everyday))
    own = {name_of(term) for term in best.candidate.terms if term not in sure}
    return len(own - taken_in(found, best))


def explains_it(found: Found, best: Optimum) -> bool:
    """Does it leave hardly more than noise, or hardly anything of what was missing?"""
    return found.yardstick.explains(best.square) or found.followed(best) >= FOLLOWED


def undecided(found: Found, equal: list[Optimum]) -> list[str]:
    """That explanations without a cause in common come out alike, or what a lone one is not."""
    others = stand_ins(found, equal[0])
    if others:
        return [
            f"{words([name_of(term) for term, own in others.items() if own == why])} {why}, and "
            "stands in for something else"
            for why in dict.fromkeys(others.values())
        ]
    best = equal[0]
    noise = found.yardstick.explains(best.square)
    if len(equal) == 1 and not noise and with_one_less(found, best) == [found.base]:
        return [
            f"{words(names(best))} together come nearest, not down to the noise, and with one of "
            "them less no more is explained than by Eq. 9 alone: it may be none of them"
        ]
    nameless = [one for one in equal if {*one.candidate.terms} & NAMELESS]
    if nameless:
        return [
            f"{words(names(nameless[0]))}, a simple torque that the library does not name, "
            f"explains as much as {words(names(best))}: {share(found, nameless[0])} of the "
            f"mismatch and {share(found, best)}"
        ]
    if len(equal) == 1:
        alone = words(names(equal[0]))
        return [f"{alone} explains most, at values at which it is not what it is called"]
    each = [f"{words(names(one)) or 'no cause'} ({share(found, one)})" for one in equal]
    return [
        "explanations that have nothing in common come out alike (shares of the mismatch): "
        f"{', '.join(each[:SUSPECTS])}"
    ]


def share(found: Found, one: Optimum) -> str:
    """How much of the mismatch it explains, all of it where the noise turned out smaller."""
    return f"{min(found.followed(one), 1.0):.0%}"


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
