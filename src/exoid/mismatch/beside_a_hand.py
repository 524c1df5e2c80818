"""What is found without the first instants of drops, and what else those may be than a hand."""

from dataclasses import replace

import numpy as np

from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.result.systematics.limiting import limited_anew
from exoid.mismatch.answer.diagnosis import Booked, Diagnosis, Suspect
from exoid.mismatch.answer.over_inertia import OVER, doubt_of, times_inertia
from exoid.mismatch.conclude.rivals import advice, suspects, value_of, with_spread
from exoid.mismatch.conclude.verdict.past_threshold import with_threshold
from exoid.mismatch.search.found import names, words

EVEN = 0.5  # the odds of a hand and of a cause: nothing tells which it is
AS_WELL = 1.2  # times the noise, up to which a cause predicts all of it


def beside_a_hand(later: Diagnosis, whole: Diagnosis) -> Diagnosis:
    """What is found of a recording without its first instants, where a hand may have been on the
    leg; with what else they may be, by the best explanation of the `whole` recording.

    The numbers stay those of the swings behind: a cause that is a little otherwise than its law
    bends them where it acts. Their errors hold what that cause would make of them.
    """
    if later.verdict != "cannot_tell":
        return later
    work = whole.workings
    assert work is not None  # it was just made
    best = work.best
    (suspect,) = suspects(work.found, [best], best)
    suspect = beside(suspect, later.before)
    told = advice([best], "cannot_tell", None, len(later.before.segments))
    then = [*later.advice, *with_threshold(told, work.found.prepared, [best])]
    return replace(
        later,
        reasons=[*later.reasons, why(words(names(best)), whole)],
        before=holding(later.before, suspect),
        suspected=[*later.suspected, suspect],
        advice=list(dict.fromkeys(then)),
    )


def why(cause: str, whole: Diagnosis) -> str:
    """What it may be as well, how well that follows all of it, and whose the numbers are."""
    shown = whole.proof
    left, all_, noise = (
        f"{np.degrees(one):.2g} deg"
        for one in (shown.after.total, shown.before.total, shown.noise_floor)
    )
    near = shown.after.total > AS_WELL * shown.noise_floor
    less = f", not to the noise of {noise}" if near else ""
    return (
        f"or it is {cause}, which predicts all of it to {left}{less} (Eq. 9: {all_}): both look "
        "alike where they act but once a drop; the leg's numbers are those of the swings behind "
        "it, as 'exoid fit' has them, whichever it is"
    )


def beside(suspect: Suspect, fit: FitResult) -> Suspect:
    """What it would make of the numbers of this fit; of those that go with J, by the fit's J."""
    inertia = fit.parameters["inertia"].value
    then = {each.name: each.after for each in suspect.numbers}
    factor = inertia / then["inertia"] if inertia and "inertia" in then else 1.0

    def here(each: Booked) -> Booked:
        now = each.after if each.name.endswith(OVER) else each.after * factor
        before = value_of(each.name, fit)
        return replace(each, before=each.before if before is None else before, after=now)

    doubt = doubt_of(fit.parameters["inertia"])
    own = [times_inertia(each, factor, doubt) for each in suspect.parameters]
    return replace(suspect, numbers=list(map(here, suspect.numbers)), parameters=own)


def holding(fit: FitResult, suspect: Suspect) -> FitResult:
    """The fit, its errors with how far this cause is from it, at even odds."""
    away = {each.name: abs(each.after - each.before) for each in suspect.numbers}
    spread = {name: EVEN**0.5 * by for name, by in away.items() if name in fit.ratios}
    return limited_anew(with_spread(fit, spread, {}), fit)
