"""What physics was left out: the whole diagnosis of recordings of one leg."""

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import Any

import jax
import numpy as np

from exoid.fitting.data.movement import Movement
from exoid.fitting.estimate import fit
from exoid.fitting.model import term_parameters
from exoid.fitting.model.coordinates import leg_parameters, torque_amplitudes
from exoid.fitting.result.fit_result import Estimate, FitResult
from exoid.mismatch.answer.diagnosis import Diagnosis, Parameter
from exoid.mismatch.conclude.choose import Chosen, causes, choose
from exoid.mismatch.conclude.conclusion import concluded
from exoid.mismatch.conclude.rivals import by_the_fits, with_rivals
from exoid.mismatch.conclude.sensor_faults import with_faults_told
from exoid.mismatch.conclude.unusual_zero import as_a_term, unusual
from exoid.mismatch.evidence.locate import locate
from exoid.mismatch.evidence.measure import misfits
from exoid.mismatch.evidence.prediction import improves
from exoid.mismatch.evidence.proof import predict
from exoid.mismatch.evidence.yardstick import SURE
from exoid.mismatch.novel.formula import Formula, fitted_words, term_of
from exoid.mismatch.novel.sparse_regression import describe
from exoid.mismatch.prepare import prepare
from exoid.mismatch.screen.effect import named as named_values
from exoid.mismatch.screen.hypothesis import Hypothesis, Optimum
from exoid.mismatch.screen.optimise import settle_free
from exoid.mismatch.search.challenge import challenged
from exoid.mismatch.search.found import Found, Workings, size
from exoid.mismatch.search.search import look
from exoid.physics.library import library
from exoid.physics.parameter import Declaration
from exoid.physics.term import SensorTerm, Term, name_of
from exoid.recordings.loading.named import RecordingsLike, named_recordings
from exoid.recordings.recording import Recording

REMAINS = 1.1  # mean square over the noise, from which on a formula is looked for
LEFT = 0.5  # of what the library leaves, that a formula may leave to take its place
KNOWN = 0.5  # share of a formula that a term of the library is, up to which it is new
STARTS = 8  # masses and inertias of the fit with what was found
AT_ONCE = 1.5  # times the noise's that a cause may leave of a movement's first instants


def diagnose(
    recordings: RecordingsLike,
    *,
    terms: tuple[type[Term], ...] = (),
    multistart: int = 64,
    seed: int = 0,
    told: Callable[[str], None] = lambda phase: None,
    **assumed: Any,
) -> Diagnosis:
    """Find where simulation and recordings part, which physics was left out, and prove it.

    `recordings` are of one leg, given as to `fit`. `terms` are tested beside the library. The
    baseline is fitted from `multistart` starts, with `assumed` being `prior`, `bounds`, `fix`,
    `bound` and `expect` as in `fit`; the search for what it misses moves its parameters freely.
    `told` hears the name of every phase.

    **Raises** `ValueError` where a recording cannot be fitted or gravity comes out upwards,
    `ArithmeticError` where no start of the baseline's fit succeeded.

    >>> found = exoid.diagnose("drops.csv", multistart=4)
    >>> found.verdict, found.selected
    ('none', [])
    """
    named = named_recordings(recordings)
    told("fitting the baseline")
    options = {"seed": seed, **assumed}
    result = fit(named, multistart=multistart, **options)
    ask = partial(asked, named=named, terms=terms, seed=seed, told=told)
    movements = [] if result.basis is None else result.basis.problem.movements
    if any(each.late for each in movements):
        at_once = {**options, "at_once": True}
        whole = ask(fit(named, multistart=multistart, **at_once))
        if names_it(whole) and not by_sensors(whole):
            later = None if from_the_first(whole, movements) else ask(result)
            if later is None or (later.changed and not names_it(later)):
                return with_model(whole, named, at_once, told)
            return with_model(later, named, options, told)
    return with_model(ask(result), named, options, told)


def with_model(
    found: Diagnosis,
    named: list[tuple[str, Recording]],
    options: dict[str, Any],
    told: Callable[[str], None],
) -> Diagnosis:
    """The same, with the fit of the model that has what was found.

    It begins where the search for what is missing ended. Where none can begin, or it follows the
    recording no better than the baseline does, the baseline stays the only one.
    """
    work = just_made(found)
    wanted = extended(found, work.best.candidate)
    if not wanted:
        before = with_rivals(found.before, work, work.found.base)
        said = before.notes[: len(before.notes) - len(found.before.notes)]
        reasons = [*found.reasons, *(each.rstrip(".") for each in said)]
        booked, suspected = by_the_fits(found, None)
        return replace(found, before=before, reasons=reasons, booked=booked, suspected=suspected)
    told("fitting the model with what was found")
    try:
        after = fit(named, multistart=STARTS, terms=wanted, near=leg_of(work), **options)
    except ArithmeticError:
        return found
    before = found.before
    if not after.follows and (before.follows or after.angle_rmse >= before.angle_rmse):
        return found
    return told_by(found, with_rivals(after, work, work.best))


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

    def told(each: Parameter) -> Parameter:
        fitted = known.get(each.name)
        if fitted is None or fitted.value is None:
            return each
        return replace(each, value=fitted.value, standard_error=fitted.standard_error)

    parameters = [told(each) for each in found.parameters]
    booked, suspected = by_the_fits(found, after)
    more: dict[str, Any] = {"booked": booked, "suspected": suspected}
    if found.formula is not None:
        more["formula"] = replace(found.formula, words=fitted_words(after.fitted_terms[0]))
    return replace(found, after=after, parameters=parameters, inertia=inertia, **more)


def for_inertia(ratio: Estimate, declared: Declaration, inertia: float) -> Estimate:
    """A parameter over J, or times J, as that of a leg with this inertia."""
    scale = inertia**declared.inertia_power
    value, error = (
        None if each is None else each * scale for each in (ratio.value, ratio.standard_error)
    )
    return replace(ratio, value=value, standard_error=error)


def just_made(found: Diagnosis) -> Workings:
    """What a diagnosis rests on that was not read from a file."""
    assert found.workings is not None
    return found.workings


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


def asked(
    result: FitResult,
    named: list[tuple[str, Recording]],
    terms: tuple[type[Term], ...],
    seed: int,
    told: Callable[[str], None],
) -> Diagnosis:
    """What is missing in a fit."""
    prepared, base = prepare(result, named, terms)
    found = challenged(look(prepared, base, told))
    told("proving it on held-out data")
    chosen = choose(found)
    formula = None
    if chosen.best.square > REMAINS * found.yardstick.samples or causes(chosen.best) > 1:
        told("looking for a formula")
        chosen, formula = formulated(found, chosen)
    found, best = with_faults_told(found, chosen.best)
    if prepared.common:
        chosen = Chosen(best, *(predict(prepared, one) for one in (found.base, best)))
    if formula is None and unusual(found, chosen.best):
        found, best = as_a_term(found, chosen.best)
        chosen = Chosen(best, *(predict(found.prepared, one) for one in (found.base, best)))
    told("locating the mismatch")
    location = locate(found.prepared, found.begin, chosen.best)
    return concluded(result, found, chosen, formula, location, seed)


def names_it(found: Diagnosis) -> bool:
    """Is something missing that the library has?"""
    return found.verdict == "mismatch" and not found.novel


def by_sensors(found: Diagnosis) -> bool:
    """Is all that was found an error of sensors? It shows as well without the first instants."""
    return all(issubclass(term, SensorTerm) for term in just_made(found).best.candidate.terms)


def from_the_first(found: Diagnosis, movements: list[Movement]) -> bool:
    """Does what was found explain the first instants, too, down to the noise? What a hand does is
    no other cause by chance.
    """
    work = just_made(found)
    each = misfits(work.found.prepared.seen, work.best.motion)
    early = [
        one[: movement.late]
        for channels, movement in zip(each, movements, strict=True)
        for one in channels
    ]
    return noise_alone(np.concatenate(early), size(work.best))


def noise_alone(left: np.ndarray, parameters: int) -> bool:
    """Is what is left over the noise no more than that? So many parameters may have been spent on
    these samples alone.
    """
    return float(left @ left) < AT_ONCE * (left.size - parameters)


def formulated(found: Found, chosen: Chosen) -> tuple[Chosen, Formula | None]:
    """The best formula as a term, where it explains more than the library does.

    One that a single cause of the library knows is that cause; a set may imitate what is new.
    """
    single = causes(chosen.best) < 2
    new = [
        each for each in describe(found.prepared, found.begin) if each.known <= KNOWN or not single
    ]
    if not new:
        return chosen, None
    tried = [free(found, each) for each in new]
    one, formula = max(zip(tried, new, strict=True), key=lambda each: found.evidence(each[0]))
    if better(found, one, chosen.best) and found.clear(found.base, one):
        after = predict(found.prepared, one)
        if improves(chosen.after, after):
            return Chosen(one, chosen.before, after), formula.at(one.candidate.values[-1])
    return chosen, None


def free(found: Found, formula: Formula) -> Optimum:
    """A formula as a term, running free from its size along the measured motion, where the leg may
    be another one, and from none.
    """
    term, count = term_of(formula), len(formula.features)
    sizes = formula.values, np.where(np.arange(formula.values.size) < count, 0.0, formula.values)
    starts = [found.begin.with_term(term, each) for each in sizes]
    ends = [settle_free(found.prepared, one) for one in starts]
    return min(ends, key=lambda one: one.square if one.sound else np.inf)


def better(found: Found, one: Optimum, best: Optimum) -> bool:
    """Does a formula explain so much more than the library that it must be something else?"""
    rival = max((best, *found.singles, *found.pairs), key=found.evidence)
    if not found.yardstick.explains(rival.square):
        return one.square < LEFT * rival.square
    return found.evidence(one) > found.evidence(rival) + SURE
