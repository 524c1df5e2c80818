"""What this recording cannot tell from the answer, and what that leaves unknown of the leg."""

from dataclasses import replace
from functools import partial

import numpy as np

from exoid.fitting.result.estimates.estimate import RIVALS, Estimate
from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.result.mountings import numbers_at
from exoid.fitting.result.remarks.zero.leaning import BENT
from exoid.fitting.result.remarks.zero.slack_angle import leaning
from exoid.mismatch.answer.diagnosis import Booked, Diagnosis, Suspect, Verdict
from exoid.mismatch.conclude.numbers import moved, parameters_of
from exoid.mismatch.evidence.yardstick import APART, REFUTED
from exoid.mismatch.novel.formula import Formula
from exoid.mismatch.screen.hypothesis import Optimum
from exoid.mismatch.search.found import Found, Workings, names, words
from exoid.physics.term import Moved, of_alike, pushing_alike

FELT = 2.0  # standard errors by which a cause that is hardly seen must move a number
LARGE = 0.1  # share of the variance, from which on a cause is worth a word
SUSPECTS = 4  # causes of which it is said what they would change
SUSPECT = 0.5  # share of the mismatch that a cause must explain to be worth a recording
REPEATED = 3  # segments that show what comes back already
REPEAT = (
    "Repeat the same movement several times: what comes back each time is physics, what does not "
    "was an event."
)
ONE_AT_A_TIME = "Change one thing at a time (speed, angle, load) and watch which moves the torque."
SLACK = f"a spring that is slack up to {np.degrees(BENT):.0f} deg from full extension"
OVER_INERTIA = {
    "stiffness": "stiffness_over_inertia",
    "damping": "damping_over_inertia",
    "gravity_moment": "gravity_over_inertia",
}


def likely(found: Found) -> list[Optimum]:
    """The single causes that explain enough of the mismatch to be worth a recording, and leave not
    so much more than the best that it refutes them.
    """
    most = REFUTED * min(one.square for one in (found.base, *found.singles, *found.pairs))
    each = [one for one in found.singles if found.followed(one) > SUSPECT]
    return [one for one in each if one.square < most]


def suspects(found: Found, each: list[Optimum], best: Optimum) -> list[Suspect]:
    """What the likeliest causes would make of the leg's numbers; the one that is named is first.
    That nothing is missing is none.
    """
    each = sorted((one for one in each if names(one)), key=lambda one: one is not best)[:SUSPECTS]
    return [
        Suspect(names(one), moved(found, found.base, one), parameters_of(found, one, None))
        for one in each
    ]


def hidden(found: Found, result: FitResult) -> list[Optimum]:
    """Causes that the data prefer to Eq. 9 alone, yet that change too little to be claimed: Eq. 9
    takes nearly all of them for something else, and its numbers are wrong by as much.
    """
    seen = [one for one in found.singles if found.evidence(one) > APART]
    return [one for one in seen if felt(result, moved(found, found.base, one))]


def felt(result: FitResult, numbers: list[Booked]) -> bool:
    """Is any ratio elsewhere, by its error?"""
    return any(
        abs(one.after - one.before) > FELT * (result.ratios[one.name].standard_error or np.inf)
        for one in numbers
        if one.name in result.ratios
    )


def of_hidden(found: Found, result: FitResult, first: Optimum) -> str:
    """Why nothing can be said, where something may hide in Eq. 9."""
    changes = [
        f"{result.ratios[one.name].symbol} {one.before:.3g} -> {one.after:.3g} {one.unit}"
        for one in moved(found, found.base, first)
        if one.name in result.ratios
    ]
    return (
        f"{words(names(first))} would explain more than noise can be, but too little to be "
        f"claimed, and the leg would be another: {', '.join(changes)}"
    )


def with_rivals(result: FitResult, work: Workings, shown: Optimum) -> FitResult:
    """The fit of `shown`, its errors with what its numbers would be by every other cause.

    Variances add the mean square distance to the numbers of all candidates, each counted by its
    odds, exp(evidence / 2): Hoeting et al., Statistical Science 14(4), 1999. What did not run free
    counts as it came out at the first look. Where the knee's spring is slack no recording need
    show: what that leaves open, of the causes' own sizes too, counts where it is more.
    """
    found = work.found
    each = [found.base, *found.singles, *found.pairs]
    freed = {one.candidate.terms for one in each}
    each += [one for one in (work.best, *found.pinned) if one.candidate.terms not in freed]
    evidence = np.array([found.evidence(one) for one in each])
    odds = np.exp((evidence - evidence.max()) / 2)
    away = [
        {number.name: number.after - number.before for number in moved(found, shown, one)}
        for one in each
    ]
    parts = {
        name: odds / odds.sum() * np.square([one.get(name, 0.0) for one in away])
        for name in result.ratios
    }
    slack = of_slack_angle(result)
    spread = {
        name: max(float(np.sqrt(part.sum())), slack.get(name, 0.0)) for name, part in parts.items()
    }
    wide = {
        name: one.symbol
        for name, one in result.ratios.items()
        if spread[name] > FELT * (one.standard_error or np.inf)
    }
    share = sum((parts[name] / spread[name] ** 2 for name in wide), np.zeros(len(each)))
    rivals = [words(names(each[k])) or "Eq. 9 alone" for k in np.flatnonzero(share > LARGE)]
    rivals += [SLACK] if any(spread[name] == slack.get(name) for name in wide) else []
    named = shown is not found.base
    doubt = "that it may be another cause" if named else "what this recording cannot exclude"
    note = f"± of {', '.join(wide.values())} covers {doubt}: {', '.join(rivals)}."
    shown_too = bool(wide) and result.follows  # else no number is shown that could have an error
    notes = [*([note] if shown_too else []), *result.notes]
    return replace(with_spread(result, spread, slack), notes=notes)


def with_spread(
    result: FitResult, of_ratios: dict[str, float], of_slack: dict[str, float]
) -> FitResult:
    """With errors that hold these, of the parameters by J: none is open `if_slack` any more."""
    inertia = result.parameters["inertia"].value or 0.0

    def held(name: str, each: Estimate) -> Estimate:
        by_ratio = inertia * of_ratios.get(OVER_INERTIA.get(name, ""), 0.0)
        by = of_ratios.get(name, max(by_ratio, of_slack.get(name, 0.0)))
        return replace(each.widened(by, cause=RIVALS), if_slack=None)

    moment = result.gravity_moment
    return replace(
        result,
        ratios={name: held(name, one) for name, one in result.ratios.items()},
        parameters={name: held(name, one) for name, one in result.parameters.items()},
        terms={
            owner: {name: held(f"{owner}.{name}", one) for name, one in own.items()}
            for owner, own in result.terms.items()
        },
        gravity_moment=moment and held("gravity_moment", moment),
    )


def of_slack_angle(result: FitResult) -> dict[str, float]:
    """How far numbers are open because nobody knows where the knee's spring is slack."""
    if result.basis is None:
        return {}
    problem, ended, free = result.basis.problem, result.basis.ended, result.basis.information.open
    found = leaning(problem, ended, free, partial(numbers_at, problem))
    return {} if found is None else found.spread


def by_the_fits(found: Diagnosis, after: FitResult | None) -> tuple[list[Booked], list[Suspect]]:
    """What the effect was booked as, and what suspects would make of the leg, as the fits have it.

    The search weighs the data otherwise than a fit: of it only the differences count, from the fit
    with what was found, or from the baseline's where there is none.
    """
    first = found.suspected[0].numbers if found.suspected else []
    here = {each.name: each.before if after is None else each.after for each in first}
    shown = found.before if after is None else after

    def fitted(each: Booked, away: float = 0.0) -> Booked:
        before, now = value_of(each.name, found.before), value_of(each.name, shown)
        if before is None or now is None:
            return each
        return replace(each, before=before, after=now + away)

    booked = found.booked if after is None else list(map(fitted, found.booked))
    return booked, [
        replace(one, numbers=[fitted(each, each.after - here[each.name]) for each in one.numbers])
        for one in found.suspected
    ]


def value_of(name: str, fit: FitResult) -> float | None:
    """A ratio, a parameter or the gravity moment of a fit."""
    return (fit.ratios | fit.of_leg)[name].value


def advice(
    rivals: list[Optimum],
    verdict: Verdict,
    formula: Formula | None,
    segments: int,
    *,
    moved: Moved = "leg",
) -> list[str]:
    """What to record next, to tell `rivals` apart, beside so many segments of what `moved`."""
    if verdict == "none":
        return []
    more = [] if segments >= REPEATED else [REPEAT]
    if formula is not None:
        return [*more, ONE_AT_A_TIME]
    terms = dict.fromkeys(term for one in rivals for term in one.candidate.terms)
    if verdict == "mismatch" and len(rivals) < 2 and not any(term.twin for term in terms):
        return []
    alike = pushing_alike(list(terms))
    said = [of_alike(alike)] if alike else []
    said += [
        f"To tell {term.title} apart: {term.isolated_by(moved)}."
        for term in terms
        if term not in alike
    ]
    return said or more or [ONE_AT_A_TIME]
