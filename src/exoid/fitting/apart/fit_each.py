"""Every segment fitted alone, and the ratios averaged: parameters lie along null directions."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from exoid.fitting.amount.manageable import manageable
from exoid.fitting.apart.alone import alone, of_each
from exoid.fitting.apart.averaged import mean_slack
from exoid.fitting.apart.means import mean_ratio, mean_term, mean_torque, scaled
from exoid.fitting.apart.said import said_of
from exoid.fitting.apart.settled import COMMON, settled_parameters
from exoid.fitting.asked import PLAIN_SCALE, classes_of, with_aside
from exoid.fitting.model.assumptions import Assumptions, by_hand
from exoid.fitting.model.belief import Belief
from exoid.fitting.model.prior_and_limits import believe
from exoid.fitting.movements import left_out, movements_in
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.estimates.scale import UNLIKE_ITS_BODY, with_reasons
from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.result.refused.without_numbers import without_numbers
from exoid.physics.term import Term, name_of
from exoid.recordings.loading.named import RecordingsLike, named_recordings
from exoid.recordings.recording import Recording

TORQUE = "torque_over_inertia"


def fit_each(given: RecordingsLike, **options) -> FitResult:
    """`fit` on every segment by itself.

    Ratios are the mean over segments, with the standard error of their scatter and of what is the
    same in all segments of a recording; the parameters are what prior and limits make of the mean
    ratios. Where one of the segments is not followed, none has a value.

    >>> each = exoid.fit_each("drops.csv")
    >>> round(each.ratios["gravity_over_inertia"].value)  # 1/s^2
    27
    """
    recordings = named_recordings(given)
    amount = manageable(recordings, of_each(recordings), average=options.get("smooth", 1) == 1)
    moving = movements_in(amount.parts, clip=options.get("clip", "free"))
    moved = {each.name for each in moving}
    parts = [part for part in amount.parts if part.name in moved]
    results = [alone(part, options) for part in parts]
    aside = [*amount.notes, *left_out(amount.parts, moving)]
    if len(results) < 2:
        return with_aside(without_numbers(results[0]), [*aside, *results[0].set_aside])
    sessions = [part.recording.subject.session for part in parts]
    owner = [sessions.index(each) for each in sessions]
    classes = classes_of(options.get("terms", ()))
    found = together(results, owner, believed(recordings, options, classes), classes)
    return replace(without_numbers(found), set_aside=aside, notes=said_of(results, aside))


def believed(
    recordings: list[tuple[str, Recording]],
    options: Mapping[str, Any],
    classes: tuple[type[Term], ...],
) -> Belief:
    """What is believed of the leg before any segment is read, by the options of `fit`."""
    plain = options.get("misfit") == "paper"
    weight = options.get("weight", 1.0) * (PLAIN_SCALE**2 if plain else 1.0)
    hand = by_hand(recordings, *(options.get(name) for name in ("fix", "bound", "expect")))
    prior, bounds = options.get("prior", "auto"), options.get("bounds", "body")
    assumed = Assumptions(prior, weight, plain, bounds, hand)
    return believe(recordings[0][1].subject, assumed, classes)


def together(
    results: Sequence[FitResult],
    owner: Sequence[int],
    belief: Belief,
    classes: tuple[type[Term], ...],
) -> FitResult:
    """One result of all segments, each of the session that is its `owner`."""
    ratios = mean_ratios(results, owner)
    parameters, moment = of_leg(results, ratios, belief)
    readings = {each.torque_frequency for each in results} - {None}
    terms = {
        name_of(each): mean_term(each, results, owner, parameters["inertia"]) for each in classes
    }
    return replace(
        results[0],
        parameters=parameters,
        ratios=ratios,
        gravity_moment=moment,
        terms=terms,
        leg=None,
        fitted_terms=(),
        torque_amplitude=mean_torque([each.torque_amplitude for each in results], owner),
        segments=[segment for each in results for segment in each.segments],
        loss=sum(each.loss for each in results),
        disturbance=max((each.disturbance for each in results), key=lambda one: one.scale),
        mountings=[mounting for each in results for mounting in each.mountings],
        basis=None,
        astray=next((each.astray for each in results if not each.follows), None),
        torque_frequency=readings.pop() if len(readings) == 1 else None,
        other_reading_rmse=None,
    )


def mean_ratios(results: Sequence[FitResult], owner: Sequence[int]) -> dict[str, Estimate]:
    """The ratios of all segments, and tau / J of those that a torque drives."""
    ratios = {name: mean_ratio([each.ratios[name] for each in results], owner) for name in COMMON}
    pairs = zip(results, owner, strict=True)
    driven = [(each.ratios[TORQUE], at) for each, at in pairs if TORQUE in each.ratios]
    if driven:
        ratios[TORQUE] = mean_ratio([one for one, _ in driven], [at for _, at in driven])
    return ratios


def of_leg(
    results: Sequence[FitResult], ratios: dict[str, Estimate], belief: Belief
) -> tuple[dict[str, Estimate], Estimate | None]:
    """m, J, l, d, c and m l g: what belief makes of the mean ratios, or why a segment that is
    unlike its body's tells none.
    """
    unlike = [each for each in results if each.parameters["inertia"].reason in UNLIKE_ITS_BODY]
    if unlike:
        told = unlike[0].parameters
    else:
        told = with_reasons(settled_parameters(belief, ratios, results[0].leg), belief.rig)
    parameters = {
        name: replace(each, if_slack=mean_slack([one.parameters[name] for one in results]))
        if each.value is not None
        else each
        for name, each in told.items()
    }
    moment, swing = [*unlike, *results][0].gravity_moment, ratios["gravity_over_inertia"]
    return parameters, moment and scaled(moment, swing, parameters["inertia"], 1)
