"""Every segment fitted alone, and the ratios averaged: parameters lie along null directions."""

import re
from dataclasses import replace

import jax
import numpy as np

from exoid.fitting.amount.manageable import TOGETHER, Amount, manageable
from exoid.fitting.amount.part import Part
from exoid.fitting.estimate import PLAIN_SCALE, classes_of, fit, with_aside
from exoid.fitting.misfit.neighbourhood import derivative
from exoid.fitting.misfit.uncertainty import Information
from exoid.fitting.model.assumptions import Assumptions, by_hand
from exoid.fitting.model.belief import NAMES, Belief
from exoid.fitting.model.constraint import NEVER, violations
from exoid.fitting.model.limits import constraint_names
from exoid.fitting.model.prior import prior_residual
from exoid.fitting.model.prior_and_limits import believe
from exoid.fitting.model.term_parameters import ratio_name
from exoid.fitting.movements import left_out, movements_in
from exoid.fitting.result.averaged import averaged, mean_slack
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.estimates.found import Found
from exoid.fitting.result.estimates.parameters import parameter_estimate
from exoid.fitting.result.estimates.scale import UNLIKE_ITS_BODY, with_reasons
from exoid.fitting.result.fit_result import FitResult
from exoid.physics.leg import GRAVITY, LegParameters
from exoid.physics.parameter import declarations
from exoid.physics.term import Term, name_of
from exoid.recordings.loading.named import RecordingsLike, named_recordings
from exoid.recordings.recording import Recording

TORQUE = "torque_over_inertia"
COMMON = ("gravity_over_inertia", "stiffness_over_inertia", "damping_over_inertia")
SIZES = ("mass", "inertia", "com_distance")
SHORT = 1024  # samples of a segment among very many
SMALLEST_ERROR = 1e-6  # relative, of a ratio: nothing is known better than that
MIXED = (
    "some cycles fit better with f = 1/T, some with 2/T (Eq. 4), and tau / J is a mean over both: "
    "choose one with torque_frequency"
)
HOLDS = 1e-6  # relative slack below which a constraint holds as an equality


def fit_each(given: RecordingsLike, **options) -> FitResult:
    """`fit` on every segment by itself.

    Ratios are the mean over segments, with the standard error of their scatter and of what is the
    same in all segments of a recording; the parameters are what prior and limits make of the mean
    ratios.

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
    sessions = [part.recording.subject.session for part in parts]
    owner = [sessions.index(each) for each in sessions]
    aside = [*amount.notes, *left_out(amount.parts, moving)]
    if len(results) < 2:
        return with_aside(results[0], [*aside, *results[0].set_aside])
    each_own = [each.ratios for each in results]
    ratios = {name: mean_ratio([own[name] for own in each_own], owner) for name in COMMON}
    driven = [(own, at) for own, at in zip(each_own, owner, strict=True) if TORQUE in own]
    if driven:
        ratios[TORQUE] = mean_ratio([own[TORQUE] for own, _ in driven], [at for _, at in driven])
    plain = options.get("misfit") == "paper"
    weight = options.get("weight", 1.0) * (PLAIN_SCALE**2 if plain else 1.0)
    hand = by_hand(recordings, *(options.get(name) for name in ("fix", "bound", "expect")))
    names = options.get("prior", "auto"), options.get("bounds", "body")
    assumed = Assumptions(names[0], weight, plain, names[1], hand)
    classes = classes_of(options.get("terms", ()))
    belief = believe(recordings[0][1].subject, assumed, classes)
    unlike = [each for each in results if each.parameters["inertia"].reason in UNLIKE_ITS_BODY]
    settled = {} if unlike else settled_parameters(belief, ratios, results[0].leg)
    parameters = unlike[0].parameters if unlike else with_reasons(settled, belief.rig)
    parameters = {
        name: replace(each, if_slack=mean_slack([one.parameters[name] for one in results]))
        if each.value is not None
        else each
        for name, each in parameters.items()
    }
    moment = [*unlike, *results][0].gravity_moment
    said = dict.fromkeys(of_every_kind([note for each in results for note in each.notes]))
    lost = [each.notes[0] for each in results if not each.follows][:1]
    readings = {each.torque_frequency for each in results} - {None}
    if len(readings) > 1:
        said[MIXED] = None
    return replace(
        results[0],
        parameters=parameters,
        ratios=ratios,
        gravity_moment=moment
        and scaled(moment, ratios["gravity_over_inertia"], parameters["inertia"], 1),
        terms={
            name_of(each): mean_term(each, results, owner, parameters["inertia"])
            for each in classes
        },
        leg=None,
        fitted_terms=(),
        torque_amplitude=mean_torque([r.torque_amplitude for r in results], owner),
        segments=[segment for each in results for segment in each.segments],
        loss=sum(each.loss for each in results),
        disturbance=max((each.disturbance for each in results), key=lambda one: one.scale),
        mountings=[mounting for each in results for mounting in each.mountings],
        basis=None,
        astray=next((each.astray for each in results if not each.follows), None),
        torque_frequency=readings.pop() if len(readings) == 1 else None,
        other_reading_rmse=None,
        set_aside=aside,
        notes=[
            *lost,
            f"every segment was fitted alone: the ratios are the mean of {len(results)} fits, "
            "their errors come from the scatter between them and from what is the same in all "
            "segments of a session, and the starts are those of the first",
            *aside,
            *(note for note in said if note not in lost),
        ],
    )


def of_every_kind(notes: list[str]) -> list[str]:
    """Of notes that differ in their numbers alone the first, unless they say of which segment."""
    kinds = {}
    for note in notes:
        kind = note if "segment" in note else re.sub(r"\d[\d.e+-]*", "", note)
        kinds.setdefault(kind, note)
    return list(kinds.values())


def of_each(recordings: list[tuple[str, Recording]]) -> Amount:
    """What is read at once: every segment, of many only what moves."""
    count = sum(len(recording.segments) for _, recording in recordings)
    steps = max(TOGETHER.steps, SHORT * count)
    return Amount(count, steps, steps)


def alone(part: Part, options: dict) -> FitResult:
    """The fit of one segment; it and what it owned keep the name they have among the others."""
    try:
        result = fit([(part.name, only(part.recording, part.number))], **options)
    except ValueError as fault:
        raise ValueError(f"segment {part.name} alone: {fault}") from fault
    named = [replace(each, name=part.name + each.name[1:]) for each in result.segments]
    owned = [replace(each, recording=part.name) for each in result.mountings]
    return replace(result, segments=named, mountings=owned)


def only(recording: Recording, number: int) -> Recording:
    """One segment as a recording of its own."""

    def own(value):
        entry = value[number] if isinstance(value, tuple) else value
        return None if isinstance(entry, float) and np.isnan(entry) else entry

    subject, protocol = recording.subject, recording.protocol
    mass = own(subject.added_mass)
    return replace(
        recording,
        segments=(recording.segments[number],),
        subject=replace(
            subject,
            added_mass=mass,
            added_mass_distance=None if mass is None else own(subject.added_mass_distance),
        ),
        protocol=replace(
            protocol,
            kind=own(protocol.kind),
            cycle_period=own(protocol.cycle_period),
            thigh_angle=own(protocol.thigh_angle),
        ),
    )


def mean_ratio(each: list[Estimate], owner: list[int]) -> Estimate:
    """The mean over the segments that tell it."""
    told = [(one, at) for one, at in zip(each, owner, strict=True) if one.value is not None]
    values = [one for one, _ in told]
    return averaged(values, [at for _, at in told]) if len(told) > 1 else [*values, *each][0]


def mean_torque(each: list[Estimate | None], owner: list[int]) -> Estimate | None:
    """The mean over the voluntary segments, where it is known of all of them."""
    there = [(one, at) for one, at in zip(each, owner, strict=True) if one is not None]
    values = [one for one, _ in there]
    if not values or any(one.value is None for one in values):
        return values[0] if values else None
    return averaged(values, [at for _, at in there])


def mean_term(
    term: type[Term], results: list[FitResult], owner: list[int], inertia: Estimate
) -> dict[str, Estimate]:
    """A term's parameters as means over the segments; what goes with J from its mean over J."""
    each = [result.terms[name_of(term)] for result in results]
    means = {
        name: averaged([one[name] for one in each], owner)
        if all(one[name].value is not None for one in each)
        else next(one[name] for one in each if one[name].value is None)
        for name in each[0]
    }
    for name, declared in declarations(term):
        if declared.inertia_power and means[name].value is not None:
            ratio = means[ratio_name(name, declared)]
            means[name] = scaled(means[name], ratio, inertia, declared.inertia_power)
    return means


def scaled(own: Estimate, ratio: Estimate, inertia: Estimate, power: int) -> Estimate:
    """ratio J^power with its error, where the prior tells J; the mean as it is where it does not.

    Fixed by hand, it stays where it is.
    """
    if own.by_hand == "fix" or inertia.value is None or ratio.value is None:
        return own
    scale = inertia.value**power
    of_inertia = power * ratio.value * (inertia.standard_error or 0.0) / inertia.value
    return replace(
        own,
        value=ratio.value * scale,
        standard_error=float(np.hypot(ratio.standard_error or 0.0, of_inertia) * abs(scale)),
    )


def settled_parameters(
    belief: Belief, ratios: dict[str, Estimate], like: LegParameters | None
) -> dict[str, Estimate]:
    """P at the mean ratios: prior and limits choose m and J, two unknowns for SciPy's SLSQP.

    A ratio that nothing tells is there as that of a leg `like` these, and weighs nothing.
    """
    from scipy.optimize import minimize

    known = np.array([ratios[name].value is not None for name in COMMON])
    assert like is not None  # every segment's own fit has one
    usual = [like.mass * like.com_distance * GRAVITY, like.stiffness, like.damping]
    told = [ratios[name].value for name in COMMON]
    values = np.where(known, np.array(told, dtype=float), np.array(usual) / like.inertia)
    errors = np.array([ratios[name].standard_error or 0.0 for name in COMMON])
    errors = np.where(known, np.maximum(errors, SMALLEST_ERROR * (1 + np.abs(values))), np.inf)
    limits, fixed = belief.limits, belief.by_hand.leg.fix
    ends = [name in fixed for name in constraint_names(0)]
    # Where the ratio is 0 as well, nothing moves; with J fixed, d and c follow from their ratios.
    movable = [name for name in fixed if name in SIZES or (fixed[name] and "inertia" not in fixed)]

    def leg(logs):
        mass, inertia = np.exp(logs[:2])
        gravity, stiffness, damping = logs[2:]
        distance = gravity * inertia / (mass * GRAVITY)
        return LegParameters(mass, inertia, distance, damping * inertia, stiffness * inertia)

    def by_prior(logs):
        return prior_residual(belief.prior, leg(logs), np)

    def violation(logs):
        no_torque = np.zeros((0, *np.shape(logs)[1:]))
        found = violations(limits, leg(logs), no_torque, np)
        return np.where(np.reshape(ends, (-1, *[1] * np.ndim(logs[0]))), NEVER, found)

    def held(logs):
        values = leg(logs)
        return np.array([getattr(values, name) - fixed[name] for name in movable])

    def at(logs):
        return np.concatenate([logs, values])

    found = minimize(
        lambda logs: float(by_prior(at(logs)) @ by_prior(at(logs))) / 2,
        np.log(first_guess(belief)),
        method="SLSQP",
        constraints=[
            {"type": "ineq", "fun": lambda logs: -violation(at(logs))},
            *([{"type": "eq", "fun": lambda logs: held(at(logs))}] if movable else []),
        ],
    )
    point = at(found.x)
    active = violation(point) > -HOLDS
    prior = derivative(by_prior, point)
    data = np.diag([0.0, 0.0, *errors**-2.0])
    gradients = derivative(lambda logs: np.stack(jax.tree.leaves(leg(logs))), point)
    rows = gradients[[NAMES.index(name) for name in fixed]]
    bound = np.concatenate([derivative(violation, point)[active], rows])
    information = Information(data, prior.T @ prior, bound, rows)
    at_bound = {name for name, holds in zip(constraint_names(0), active, strict=True) if holds}
    return {
        name: parameter_estimate(
            name, belief, Found(float(value), gradient, information, name in at_bound)
        )
        for name, value, gradient in zip(NAMES, jax.tree.leaves(leg(point)), gradients, strict=True)
    }


def first_guess(belief: Belief) -> np.ndarray:
    """m [kg] and J [kg m^2]: what anatomy expects, else those of a middling leg."""
    typical = belief.typical
    return np.array([typical.get("mass", 4.0), typical.get("inertia", 0.4)])
