"""The fit of the model that has what was found, and the answer with its numbers."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import jax
import numpy as np

from exoid.fitting.estimate import fit
from exoid.fitting.model import term_parameters
from exoid.fitting.model.coordinates import leg_parameters, torque_amplitudes
from exoid.fitting.result.agreement import astray
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.result.systematics.limiting import limited_anew
from exoid.fitting.result.untold import if_times_right
from exoid.mismatch.answer.diagnosis import Diagnosis, Parameter, just_made
from exoid.mismatch.answer.over_inertia import doubt_of, times_inertia
from exoid.mismatch.answer.own_words import in_own_words
from exoid.mismatch.conclude.asserted import same_cause
from exoid.mismatch.conclude.rivals import (
    advice,
    by_the_fits,
    likely,
    suspects,
    with_rivals,
)
from exoid.mismatch.conclude.twin_sizes import as_fitted, twin_sizes
from exoid.mismatch.conclude.verdict.cannot_tell import unlike_a_leg
from exoid.mismatch.conclude.verdict.past_threshold import with_threshold
from exoid.mismatch.conclude.verdict.segments.own_torques import RELAXED
from exoid.mismatch.novel.formula import fitted_formula
from exoid.mismatch.screen.effect import named as named_values
from exoid.mismatch.screen.hypothesis import Hypothesis
from exoid.mismatch.search.found import Workings, words
from exoid.physics.library import library
from exoid.physics.parameter import Declaration
from exoid.physics.term import Term, name_of
from exoid.recordings.recording import Recording

STARTS = 8  # masses and inertias of the fit with what was found
ALONE = "Let the leg go at once, touch nothing until it hangs still, and record again."
ELSEWHERE = 2.0  # times the held-out error, above which a fit is none of what the search found


def with_model(
    found: Diagnosis,
    named: list[tuple[str, Recording]],
    options: dict[str, Any],
    told: Callable[[str], None],
) -> Diagnosis:
    """The same, with the fit of the model that has what was found, in words of the leg or rig.

    It begins where the search for what is missing ended. Where none can begin, or it does not
    follow the recording, the baseline stays the only one; where that does not follow either, what
    was found is not claimed.
    """
    return in_own_words(modelled(found, named, options, told))


def modelled(
    found: Diagnosis,
    named: list[tuple[str, Recording]],
    options: dict[str, Any],
    told: Callable[[str], None],
) -> Diagnosis:
    """The same in words of a leg."""
    work = just_made(found)
    wanted = extended(found, work.best.candidate)
    if not wanted:
        return by_eq9(found)
    told("fitting the model with what was found")
    try:
        after = fit(named, multistart=STARTS, terms=wanted, near=leg_of(work), **options)
    except ArithmeticError:
        after = None
    if reasons := doubts(found, after):
        return by_eq9(unclaimed(found, reasons))
    if after is None or not after.follows:
        return found
    return told_by(found, limited_anew(with_rivals(after, work, work.best), after))


def doubts(found: Diagnosis, after: FitResult | None) -> list[str]:
    """Why the model with what was found is no answer."""
    if after is not None and ended_elsewhere(found, after):
        searched, fitted = (
            f"{np.degrees(one):.2g} deg" for one in (found.proof.after.total, after.angle_rmse)
        )
        return [
            f"{words(found.selected) or 'a formula'} predicts what it did not see to {searched}, "
            f"but the fit with it stands in another minimum, at {fitted}"
        ]
    if after is not None and after.follows and after.basis is not None:
        gravity = map(if_times_right, (found.before, after))
        return unlike_a_leg(after.basis.problem.belief, *gravity)
    if found.before.follows:
        return []
    cause = words(found.selected) or "a formula"
    return [f"{cause} explains most, but with it the model is still astray"]


def ended_elsewhere(found: Diagnosis, after: FitResult) -> bool:
    """Does a fit of all samples leave far more than the search did of those that it did not see?"""
    return bool(after.follows and after.angle_rmse > ELSEWHERE * found.proof.after.total)


def unclaimed(found: Diagnosis, reasons: list[str]) -> Diagnosis:
    """The same without what was found, which is only what it may be."""
    own, best = just_made(found).found, just_made(found).best
    each = likely(own) or [best]
    nothing: dict[str, Any] = {"findings": [], "novel": False, "formula": None}
    suspected = suspects(own, each, best)
    prepared = own.prepared
    then = advice(each[:2], "cannot_tell", None, prepared.segments, moved=prepared.moved)
    then = with_threshold(then, prepared, each[:2])
    more: dict[str, Any] = {"suspected": suspected, "advice": then}
    return replace(found, verdict="cannot_tell", reasons=reasons, **nothing, **more)


def by_eq9(found: Diagnosis) -> Diagnosis:
    """The same with the numbers of Eq. 9 alone, and what others would make of them, all for one
    inertia: that of the fit where it follows, else that which the search took.
    """
    work = just_made(found)
    before = with_rivals(found.before, work, work.found.base)
    said = [each.rstrip(".") for each in before.notes if each not in found.before.notes]
    booked, suspected = by_the_fits(found, None)
    inertia = (before.parameters["inertia"].value if before.follows else None) or found.inertia
    larger = inertia / found.inertia
    doubt = doubt_of(before.parameters["inertia"]) if before.follows else 0.0
    own: dict[str, Any] = {
        "inertia": inertia,
        "location": found.location.with_inertia(inertia),
        "parameters": [times_inertia(each, larger, doubt) for each in found.parameters],
        "suspected": [as_fitted(one, [], [], larger, doubt) for one in suspected],
    }
    before = limited_anew(before, found.before)
    same = replace(found, before=before, booked=booked, **own)
    if not found.follows and astray(before.segments):
        return lost(same)
    return replace(same, reasons=[*found.reasons, *said])


def lost(found: Diagnosis) -> Diagnosis:
    """That no model follows the recording comes first, and what of it to look at: no cause is told
    apart from others there.
    """
    why = f"no model here follows the recording: {found.before.astray}"
    if not any(each.kind == "passive" for each in found.before.segments):
        return replace(found, reasons=[why, *found.reasons])
    if found.location.rig:
        return replace(found, reasons=[why, *found.reasons], advice=[ALONE])
    why += (
        ". A stretch reflex (spasticity) that differs from drop to drop, a hand that leads the leg "
        "or stops it, and what it strikes are in no model"
    )
    then = [each for each in found.advice if each == RELAXED] or [ALONE]
    return replace(found, reasons=[why, *found.reasons], advice=then)


def told_by(found: Diagnosis, after: FitResult) -> Diagnosis:
    """The same with the numbers of the fit that has what was found.

    What that fit only tells over J is given for the inertia that goes with the diagnosis.
    """
    inertia = after.parameters["inertia"].value or found.inertia
    known = after.of_terms
    for name, declared in term_parameters.parameters_of(
        [type(term) for term in after.fitted_terms]
    ):
        if declared.inertia_power and known[name].value is None:
            known[name] = for_inertia(
                known[term_parameters.ratio_name(name, declared)], declared, inertia
            )

    shared = {each.includes() for each in after.fitted_terms}

    def told(each: Parameter) -> Parameter:
        fitted = known.get(each.name)
        if each.unit == "N m" and is_part_of(each.name, shared):
            return replace(each, standard_error=None)  # another term has the rest of it
        if fitted is None:
            return each
        if fitted.value is None:  # it made up for what the fit has a name for, as a hand's release
            return replace(each, standard_error=None)
        return replace(each, value=fitted.value, standard_error=fitted.standard_error)

    parameters = [told(each) for each in found.parameters]
    booked, each = by_the_fits(found, after)
    twins = twin_sizes(after, found.equivalent, inertia)
    sizes, larger = [*parameters, *twins], inertia / found.inertia
    doubt = doubt_of(after.parameters["inertia"])
    suspected = [as_fitted(one, found.best.terms, sizes, larger, doubt) for one in each]
    more: dict[str, Any] = {"booked": booked, "suspected": suspected, "twins": twins}
    if found.formula is not None and after.leg is not None:
        own = fitted_formula(after.fitted_terms).times(inertia / float(after.leg.inertia))
        more["formula"] = replace(found.formula, words=own.words, over_inertia=own.over(inertia))
    place = found.location.with_inertia(inertia)
    more |= {"location": place, "inertia": inertia}
    return replace(found, after=after, parameters=parameters, **more)


def is_part_of(parameter: str, names: set[str]) -> bool:
    """Is it of a term, or of a form of one, that is among these?"""
    owner = parameter.partition(".")[0]
    return any(
        name_of(other) in names and same_cause(term, other)
        for term in library()
        if name_of(term) == owner
        for other in library()
    )


def for_inertia(ratio: Estimate, declared: Declaration, inertia: float) -> Estimate:
    """A parameter over J, or times J, as that of a leg with this inertia."""
    scale = inertia**declared.inertia_power
    value, error = (
        None if each is None else each * scale for each in (ratio.value, ratio.standard_error)
    )
    return replace(ratio, value=value, standard_error=error)


def extended(found: Diagnosis, best: Hypothesis) -> tuple[Term, ...]:
    """The terms of the model that was concluded, where they were found; none where it is Eq. 9."""
    if found.verdict != "mismatch":
        return ()
    having = [named_values(*each) for each in zip(best.terms, best.values, strict=True)]
    return (*having, *told_by_sensors(found, best.terms))


def leg_of(work: Workings) -> np.ndarray:
    """(m, J, l, d, c, tau) of the model that was concluded."""
    at = work.found.prepared.coordinates(work.best.candidate)
    torques = torque_amplitudes(at, np)
    moved = torques[[each.voluntary for each in work.found.prepared.problem.movements]]
    torque = moved.mean() if moved.size else 0.0
    return np.array([*jax.tree.leaves(leg_parameters(at, np)), torque], dtype=float)


def told_by_sensors(found: Diagnosis, having: tuple[type[Term], ...]) -> list[Term]:
    """What was found of the sensors although every candidate has it, as a gyro's bias."""
    values = {each.name: each.value for each in found.parameters}
    others = [each for each in library() if each not in having]
    return [
        term_parameters.term_of(each, lambda name, _: values[name])
        for each in others
        if name_of(each) in found.selected
        and all(name in values for name, _ in term_parameters.parameters_of((each,)))
    ]
