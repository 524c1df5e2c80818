"""Every segment fitted alone, and the ratios averaged; parameters along null directions must not be."""

from dataclasses import replace

import numpy as np

from exoid.fit.belief import NAMES, Belief, believe
from exoid.fit.constraint import constraint_names, violations
from exoid.fit.estimate import PLAIN_SCALE, fit, parameter_estimate, with_reasons
from exoid.fit.local import derivative
from exoid.fit.prior import prior_residual
from exoid.fit.result import Estimate, FitResult
from exoid.fit.uncertainty import Information
from exoid.physics.leg import GRAVITY, LegParameters
from exoid.recording.recording import Recording

COMMON = ("gravity_over_inertia", "stiffness_over_inertia", "damping_over_inertia")
HOLDS = 1e-6  # relative slack below which a constraint holds as an equality


def fit_each(recordings: list[tuple[str, Recording]], **options) -> FitResult:
    """`fit` on every segment by itself. Ratios are the mean over segments, with the standard error
    of their scatter; the parameters are what prior and limits make of the mean ratios.
    """
    results = [
        fit([(f"{name}[{number}]", only(recording, number))], **options)
        for name, recording in recordings
        for number in range(len(recording.segments))
    ]
    if len(results) < 2:
        return results[0]
    ratios = {name: averaged([each.ratios[name] for each in results]) for name in COMMON}
    torques = [r.ratios["torque_over_inertia"] for r in results if len(r.ratios) > len(COMMON)]
    if torques:
        ratios["torque_over_inertia"] = averaged(torques)
    plain = options.get("misfit") == "paper"
    weight = options.get("weight", 1.0) * (PLAIN_SCALE**2 if plain else 1.0)
    belief = believe(recordings[0][1].subject, options.get("prior", "de_leva"), weight, plain)
    said = dict.fromkeys(note for each in results for note in each.notes)
    return replace(
        results[0],
        parameters=with_reasons(settled_parameters(belief, ratios), not np.isfinite(belief.limits.reach)),
        ratios=ratios,
        segments=[segment for each in results for segment in each.segments],
        loss=sum(each.loss for each in results),
        notes=[
            f"every segment was fitted alone: the ratios are the mean of {len(results)} fits, their "
            "errors come from the scatter between them, and the starts are those of the first",
            *said,
        ],
    )


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
            protocol, kind=own(protocol.kind), cycle_period=own(protocol.cycle_period)
        ),
    )


def averaged(each: list[Estimate]) -> Estimate:
    """The mean of the values, with the standard error that their scatter gives it."""
    values = np.array([one.value for one in each], dtype=float)
    error = float(values.std(ddof=1) / np.sqrt(values.size)) if values.size > 1 else None
    return replace(each[0], value=float(values.mean()), standard_error=error)


def settled_parameters(belief: Belief, ratios: dict[str, Estimate]) -> dict[str, Estimate]:
    """P from the mean ratios, prior and limits: five unknowns, so SciPy's SLSQP will do."""
    from scipy.optimize import minimize

    values = np.array([ratios[name].value for name in COMMON], dtype=float)
    errors = np.array([ratios[name].standard_error for name in COMMON], dtype=float)
    errors = np.maximum(errors, 1e-6 * np.abs(values))
    limits = belief.limits
    nothing = np.zeros(0)

    def leg(logs):
        return LegParameters(*np.exp(logs))

    def by_ratio(logs):
        mass, inertia, distance, damping, stiffness = np.exp(logs)
        each = np.array([mass * distance * GRAVITY, stiffness, damping]) / inertia
        return (each - values) / errors

    def by_prior(logs):
        return prior_residual(belief.prior, leg(logs), np)

    def slack(logs):
        return -violations(limits, leg(logs), nothing, np)

    begin = np.log(first_guess(belief, values))
    found = minimize(
        lambda logs: (by_ratio(logs) @ by_ratio(logs) + by_prior(logs) @ by_prior(logs)) / 2,
        begin,
        method="SLSQP",
        constraints={"type": "ineq", "fun": slack},
        options={"maxiter": 500, "ftol": 1e-12},
    )
    active = slack(found.x) < HOLDS
    data, prior = derivative(by_ratio, found.x), derivative(by_prior, found.x)
    information = Information(
        data.T @ data, prior.T @ prior, derivative(slack, found.x)[active]
    )
    names = constraint_names(0)
    at_bound = {name for name, holds in zip(names, active, strict=True) if holds}
    return {
        name: parameter_estimate(
            name, belief, float(value), information, np.exp(found.x[number]) * unit, at_bound
        )
        for number, (name, value, unit) in enumerate(
            zip(NAMES, np.exp(found.x), np.eye(len(NAMES)), strict=True)
        )
    }


def first_guess(belief: Belief, ratios: np.ndarray) -> np.ndarray:
    """m, J, l, d, c: what anatomy expects, else 4 kg and the mean ratios with J = 0.4 kg m^2."""
    if belief.expected is not None:
        return np.array([getattr(belief.expected, name).value for name in NAMES])
    gravity, stiffness, damping = np.maximum(ratios, 1e-6)
    inertia = 0.4
    return np.array([4.0, inertia, gravity * inertia / (4.0 * GRAVITY), damping * inertia, stiffness * inertia])
