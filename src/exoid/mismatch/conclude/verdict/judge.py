"""None, mismatch, or an honest doubt."""

from dataclasses import dataclass

import numpy as np

from exoid.fitting.result.fit_result import FitResult
from exoid.mismatch.answer.diagnosis import Verdict
from exoid.mismatch.conclude.false_alarm import Chance
from exoid.mismatch.conclude.numbers import leg_of, taken_in
from exoid.mismatch.conclude.rivals import hidden, of_hidden
from exoid.mismatch.conclude.verdict.begins_and_ends import begins_and_ends, what_next
from exoid.mismatch.conclude.verdict.cannot_tell import (
    broken,
    chance,
    faint,
    filtered_away,
    luck,
    too_little,
    unrelaxed,
    unsure,
    vague,
)
from exoid.mismatch.conclude.verdict.moved_by_tone import WITHOUT_TONE, moved_by_tone
from exoid.mismatch.conclude.verdict.nothing_missing import of_what_hides, of_zeros
from exoid.mismatch.conclude.verdict.segments.apart_in_time import apart_in_time
from exoid.mismatch.conclude.verdict.segments.in_few_segments import once
from exoid.mismatch.conclude.verdict.segments.other_sizes import of_other_sizes
from exoid.mismatch.conclude.verdict.segments.own_torques import (
    RELAXED,
    of_own_torques,
    own_torques,
)
from exoid.mismatch.conclude.verdict.struck import struck
from exoid.mismatch.conclude.verdict.undecided import share, undecided
from exoid.mismatch.evidence.location import Location
from exoid.mismatch.evidence.prediction import Proof
from exoid.mismatch.evidence.yardstick import FOLLOWED
from exoid.mismatch.novel.formula import Formula
from exoid.mismatch.screen.hypothesis import Optimum
from exoid.mismatch.search.found import Found, names, words
from exoid.physics.term import Term, name_of


@dataclass(frozen=True, eq=False)
class Case:
    """What a verdict is about."""

    result: FitResult  # of Eq. 9
    found: Found
    best: Optimum
    formula: Formula | None
    certain: tuple[type[Term], ...]  # of its causes
    equal: list[Optimum]  # that explain as much
    biased: bool  # is the gyro's zero surely off?
    location: Location


@dataclass(frozen=True, eq=False)
class Judgement:
    """A verdict, and why."""

    verdict: Verdict
    reasons: list[str]
    unseen: list[Optimum]  # what may hide where nothing is missing
    then: list[str]  # to record, where no cause of the library is behind it
    but_ends: bool  # is nothing missing but where movements begin or end?


def judge(case: Case, shown: Proof, repeated: float | None, lucky: Chance) -> Judgement:
    """The verdict by proof, by how often resampled segments repeat it, and by luck."""
    result, found = case.result, case.found
    if moved := moved_by_tone(result):
        return Judgement("cannot_tell", moved, [], [WITHOUT_TONE], but_ends=False)
    for look in (apart_in_time, struck):
        reasons, then = look(found, case.best)
        if reasons:
            return Judgement("cannot_tell", reasons, [], then, but_ends=False)
    verdict, reasons = by_proof(found, case.best, shown, repeated, lucky)
    unseen = hidden(found, result) if verdict == "none" else []
    if unseen:
        verdict, reasons = "cannot_tell", [of_hidden(found, result, unseen[0])]
    if verdict == "mismatch" and case.formula is None and not case.certain:
        alone = [] if explains_it(found, case.best) else once(found.prepared, case.best)
        verdict, reasons = "cannot_tell", [*alone, *undecided(found, case.equal)]
    if verdict != "cannot_tell" and case.biased:
        verdict = "mismatch"
    if verdict == "none":
        reasons = [*of_zeros(result, found.prepared), *of_what_hides(result)]
    if verdict == "mismatch" and (doubts := of_what_is_left(case)):
        verdict, reasons = "cannot_tell", doubts
    movements = found.prepared.problem.movements
    if verdict != "none" and (own := of_own(case)):
        return Judgement("cannot_tell", own, unseen, [RELAXED], but_ends=False)
    if verdict == "cannot_tell" or case.formula is not None:
        unlike, then = of_other_sizes(found, case.best)
        if unlike:
            return Judgement("cannot_tell", unlike, unseen, then, but_ends=False)
    but_ends = case.best is found.base and reasons == begins_and_ends(movements)
    then = what_next(movements) if but_ends else []
    return Judgement(verdict, reasons, unseen, then, but_ends)


def of_own(case: Case) -> list[str]:
    """That a torque of its own in each drop of a leg explains what is missing, and what else does;
    no cause that acts alike in all drops looks like that.
    """
    prepared, best = case.found.prepared, case.best
    passive = all(each.kind == "passive" for each in prepared.problem.movements)
    torques = own_torques(case.location) if passive and not prepared.rig else {}
    if not torques or too_little(prepared) or broken(prepared):
        return []
    guessed = guess_of(case.result, case.found, best) is not None
    said = of_own_torques(torques, float(case.location.inertia or np.nan), guessed=guessed)
    if best is case.found.base:
        return [said]
    return [said, f"{words(names(best))} explains {share(case.found, best)} of it, too"]


def of_what_is_left(case: Case) -> list[str]:
    """Why what was found may be no cause, where it leaves much, or is a formula."""
    prepared, best = case.found.prepared, case.best
    if explains_it(case.found, best) and not case.formula:
        return []
    doubts = once(prepared, best) or unrelaxed(prepared, best)
    doubts = doubts or vague(case.formula, guess_of(case.result, case.found, best))
    return doubts or filtered_away(prepared, case.formula)


def guess_of(result: FitResult, found: Found, best: Optimum) -> float | None:
    """The inertia that the search took, where nothing tells one [kg m^2]."""
    told = result.parameters["inertia"].value is not None
    return None if told else float(np.exp(leg_of(found, best).log_inertia))


def by_proof(
    found: Found, best: Optimum, shown: Proof, repeated: float | None, lucky: Chance
) -> tuple[Verdict, list[str]]:
    """The verdict on the best explanation by itself."""
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
        doubts = begins_and_ends(prepared.problem.movements)
        return ("cannot_tell", doubts) if doubts else ("none", [])
    explained, causes = explains_it(found, best), claimed_at_once(found, best)
    doubts = [
        *little,
        *unsure(prepared, best, shown, explained=explained),
        *faint(found.base.square / found.yardstick.samples, causes),
        *chance(repeated, causes),
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
