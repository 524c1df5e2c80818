"""What physics was left out: the whole diagnosis of recordings of one leg."""

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from exoid.fitting.amount.manageable import DIAGNOSED
from exoid.fitting.data.movement import Movement
from exoid.fitting.estimate import fit
from exoid.fitting.result.fit_result import FitResult
from exoid.mismatch.answer.diagnosis import Diagnosis, just_made
from exoid.mismatch.beside_a_hand import beside_a_hand
from exoid.mismatch.conclude.choose import Chosen, choose
from exoid.mismatch.conclude.formulated import by_what_is_left, formulated
from exoid.mismatch.conclude.plainest import plainest
from exoid.mismatch.conclude.sensor_faults import with_faults_told
from exoid.mismatch.conclude.unusual_zero import as_a_term, odder, unusual
from exoid.mismatch.conclude.verdict.cannot_tell import too_little
from exoid.mismatch.conclude.verdict.conclusion import concluded
from exoid.mismatch.conclude.verdict.moved_by_tone import moved_by_tone
from exoid.mismatch.evidence.locate import locate
from exoid.mismatch.evidence.measure import misfits, yardstick
from exoid.mismatch.evidence.proof import predict
from exoid.mismatch.prepare import prepare
from exoid.mismatch.screen.hypothesis import Optimum
from exoid.mismatch.screen.optimise import settle_free
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.mismatch.search.challenge import challenged, with_hidden
from exoid.mismatch.search.found import Found, causes, names, size
from exoid.mismatch.search.search import look
from exoid.mismatch.stand_in import leading, with_nameless
from exoid.mismatch.with_model import with_model
from exoid.physics.term import SensorTerm, Term
from exoid.recordings.loading.named import RecordingsLike, named_recordings
from exoid.recordings.recording import Recording

REMAINS = 1.1  # mean square over the noise, from which on a formula is looked for
OUTNUMBERED = 10  # samples of the first instants beside every parameter that explains them
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
    options = {"seed": seed, "most": DIAGNOSED, **assumed}
    result = fit(named, multistart=multistart, **options)
    ask = partial(asked, named=named, terms=terms, seed=seed, told=told)
    movements = [] if result.basis is None else result.basis.problem.movements
    if any(each.late or each.slow for each in movements):
        at_once = {**options, "at_once": True}
        whole = ask(fit(named, multistart=multistart, **at_once))
        if names_it(whole) and not by_sensors(whole):
            later = None if from_the_first(whole, movements) else ask(result)
            if later is None or (not names_it(later) and may_be(later, whole.selected)):
                return with_model(whole, named, at_once, told)
            return beside_a_hand(with_model(later, named, options, told), whole)
    return with_model(ask(result), named, options, told)


def asked(
    result: FitResult,
    named: list[tuple[str, Recording]],
    terms: tuple[type[Term], ...],
    seed: int,
    told: Callable[[str], None],
) -> Diagnosis:
    """What is missing in a fit."""
    prepared, base = prepare(result, named, terms)
    if too_little(prepared) or moved_by_tone(result):
        return unsought(result, prepared, base, seed)
    found = challenged(look(prepared, base, told))
    told("proving it on held-out data")
    chosen = choose(found)
    formula = None
    if chosen.best.square > REMAINS * found.yardstick.samples or causes(chosen.best) > 1:
        told("looking for a formula")
        chosen, formula = formulated(found, chosen)
    if formula is not None:
        done = {one.candidate.terms for one in found.singles}
        others = [one for one in found.pinned if one.candidate.terms not in done]
        raced = with_hidden(found, others, told)  # before something is called new
        if raced is not found:
            found = raced
            chosen, formula = formulated(found, choose(found))
    if formula is not None:
        found = by_what_is_left(found, chosen.best)
    found, best = with_faults_told(found, chosen.best)
    if prepared.common:
        chosen = Chosen(best, *(predict(prepared, one) for one in (found.base, best)))
    if formula is None and unusual(found, odd := odder(found, chosen.best)):
        found, best = as_a_term(found, odd)
        chosen = Chosen(best, *(predict(found.prepared, one) for one in (found.base, best)))
    if formula is None and (plain := plainest(found, chosen.best)) is not chosen.best:
        chosen = replace(chosen, best=plain, after=predict(found.prepared, plain))
    if formula is None and chosen.best is not found.base:
        told("trying simple torques without a name")
        found = with_nameless(found, chosen.best)
        if (led := leading(found, chosen.best)) is not chosen.best:
            chosen = replace(chosen, best=led, after=predict(found.prepared, led))
    told("locating the mismatch")
    location = locate(found.prepared, found.begin, chosen.best)
    return concluded(result, found, chosen, formula, location, seed)


def unsought(result: FitResult, prepared: PreparedRecording, base: Optimum, seed: int) -> Diagnosis:
    """The answer to a recording that could show nothing but the baseline, or a tone."""
    if prepared.common:
        base = settle_free(prepared, base.candidate.without(prepared.common))
    found = Found(prepared, base, base.candidate, [], [], [], [], yardstick(prepared, base))
    before, location = predict(prepared, base), locate(prepared, base.candidate, base)
    return concluded(result, found, Chosen(base, before, before), None, location, seed)


def names_it(found: Diagnosis) -> bool:
    """Is something missing that the library has?"""
    return found.verdict == "mismatch" and not found.novel


def may_be(found: Diagnosis, named: list[str]) -> bool:
    """Is one of these names among what is missing, though it cannot tell?"""
    each = [name for one in found.equivalent for name in one.split(" + ")]
    return not {*names(just_made(found).best), *each}.isdisjoint(named)


def by_sensors(found: Diagnosis) -> bool:
    """Is all that was found an error of sensors? It shows as well without the first instants."""
    return all(issubclass(term, SensorTerm) for term in just_made(found).best.candidate.terms)


def from_the_first(found: Diagnosis, movements: list[Movement]) -> bool:
    """Does what was found explain the first instants, too, down to the noise? What a hand does is
    no other cause by chance.
    """
    work = just_made(found)
    seen = work.found.prepared.seen
    late = np.array([[each.slow or each.segment.time[each.late]] for each in movements])
    early = seen.time < late
    each = misfits(seen.weighed(early), work.best.motion)
    left = np.concatenate([one for channels in each for one in channels])
    return noise_alone(left, size(work.best))


def noise_alone(left: np.ndarray, parameters: int) -> bool:
    """Is what is left over the noise no more than that? So many parameters may have been spent on
    these samples alone, and of few samples they explain anything.
    """
    freedom = left.size - parameters
    return freedom > OUTNUMBERED * parameters and float(left @ left) < AT_ONCE * freedom
