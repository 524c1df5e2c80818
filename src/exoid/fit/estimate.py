"""`fit`: from recordings of one leg to its parameters, with errors, reasons and what fits as well."""

from dataclasses import replace
from typing import Literal

import numpy as np

from exoid.fit.belief import NAMES, Belief, PriorName, believe
from exoid.fit.conditioning import conditioned
from exoid.fit.constraint import constraint_names
from exoid.fit.multistart import FEASIBLE, SAME_LOSS, Ended, Problem, finite, pose, search
from exoid.fit.observation import Movement, movement
from exoid.fit.result import Estimate, FitResult, MultistartReport, SegmentFit
from exoid.fit.starts import draw, informed
from exoid.fit.uncertainty import Information, source
from exoid.physics.leg import GRAVITY, LegParameters
from exoid.physics.parameter import declarations
from exoid.physics.torque import CycleTorque
from exoid.recording.recording import Recording

MIDDLING = (4.0, 0.4)  # kg, kg m^2: where nothing is expected
PLAIN_SCALE = 1e3  # 1/rad: the solver's tolerances are in units of noise, here 1 mrad
READINGS = ("1/T", "2/T")  # of Eq. 4
RATIOS = {  # name: symbol, unit, title
    "gravity_over_inertia": ("m l g / J", "1/s^2", "gravity over inertia"),
    "stiffness_over_inertia": ("c / J", "1/s^2", "stiffness over inertia"),
    "damping_over_inertia": ("d / J", "1/s", "damping over inertia"),
    "torque_over_inertia": ("tau / J", "1/s^2", "torque over inertia"),
}
SCALE_FREE = (
    "motion alone fixes only the ratios to J: record a drop with a known mass, measure the torque, "
    "or give body mass and height"
)
SCALE_FREE_RIG = (
    "motion alone fixes only the ratios to J: record it with a known mass, or with a measured "
    "torque that varies"
)
MASS_AND_DISTANCE = "motion shows only the product m l: weigh the part or measure l"


def fit(
    recordings: list[tuple[str, Recording]] | Recording,
    *,
    multistart: int = 64,
    seed: int = 0,
    prior: PriorName = "de_leva",
    weight: float = 1.0,
    method: Literal["lm", "slsqp"] = "lm",
    smooth: int = 1,
    misfit: Literal["weighted", "paper"] = "weighted",
    starts: np.ndarray | None = None,
) -> FitResult:
    """Fit one leg to all segments of the recordings (Eq. 9-13).

    `recordings` are (name, recording) pairs, or one recording; all are of one leg. `weight` is
    lambda of Eq. 11 in standardised units. `smooth` is the window of Eq. 3 in samples, applied to
    data and simulation alike. `misfit` "paper" is Eq. 11 as printed: the angle alone in rad, and
    the prior in the parameters' own units. `starts`, (start, 6) in the order m, J, l, d, c, tau,
    replace the draw from the bounds of Eq. 13 by `seed`.

    **Raises** `ValueError` where the recording cannot be fitted, `ArithmeticError` where no start
    succeeded.
    """
    named = [("recording", recordings)] if isinstance(recordings, Recording) else recordings
    movements = [
        movement(recording, number, f"{name} {number}" if len(named) > 1 else str(number))
        for name, recording in named
        for number in range(len(recording.segments))
    ]
    plain = misfit == "paper"
    belief = believe(named[0][1].subject, prior, weight * PLAIN_SCALE**2 if plain else weight, plain)
    if plain:
        movements = [plainly(each) for each in movements]
    chain, movements = conditioned(movements, smooth)
    tried = {
        reading: solved(
            pose(movements, belief, reading, chain),
            begin(movements, belief, reading, multistart, seed) if starts is None else starts,
            method,
        )
        for reading in readings(named, movements)
    }
    best = min(tried, key=lambda reading: float(tried[reading][1].best.loss[0]))
    problem, ended = tried[best]
    others = [describe(*tried[reading], None, None).angle_rmse for reading in tried if reading != best]
    voluntary = any(each.voluntary for each in movements)
    return describe(problem, ended, best if voluntary else None, others[0] if others else None)


def begin(
    movements: list[Movement], belief: Belief, reading: str, count: int, seed: int
) -> np.ndarray:
    """The starts: two informed ones, from anatomy and from inverse dynamics, the rest drawn."""
    starts = draw(count, seed)
    mass, inertia = MIDDLING
    if belief.expected is not None:
        each = [getattr(belief.expected, name).value for name in NAMES]
        mass, inertia = each[:2]
        starts[0] = [*each, 0.0]
    guess = informed(movements, reading, mass, inertia)
    if count > 1 and guess is not None:
        starts[1] = guess
    return starts


def plainly(each: Movement) -> Movement:
    """Weigh every angle alike and leave the velocity out, as Eq. 11 does."""
    return replace(
        each, angle_noise=1 / PLAIN_SCALE, angular_velocity=None, velocity_noise=np.inf
    )


def readings(named: list[tuple[str, Recording]], movements: list[Movement]) -> tuple[str, ...]:
    """The readings of Eq. 4 to try: as the sidecar says, else both; one where no cycle is."""
    said = {recording.protocol.torque_frequency for _, recording in named} - {None}
    if not any(each.voluntary for each in movements):
        return READINGS[:1]
    return tuple(sorted(said)) if said else READINGS  # type: ignore[arg-type]


def solved(problem: Problem, starts: np.ndarray, method: str) -> tuple[Problem, Ended]:
    """The search by the chosen method."""
    if method == "slsqp":
        from exoid.fit.slsqp import search_slsqp

        return problem, search_slsqp(problem, starts)
    return problem, search(problem, starts)


def describe(
    problem: Problem, ended: Ended, reading: str | None, other_rmse: float | None
) -> FitResult:
    """The numbers with their errors, units and reasons."""
    best, local = ended.best, ended.local
    segments = len(problem.movements)
    names = constraint_names(segments)
    active = best.multiplier[0] > 0
    information = Information(
        data=local.data, prior=local.prior, active=local.constraints[active]
    )
    at_bound = {name for name, hold in zip(names, active, strict=True) if hold}
    belief = problem.belief
    parameters = {
        name: parameter_estimate(
            name,
            belief,
            float(getattr(best.leg, name)[0]),
            information,
            local.parameters[number],
            at_bound,
        )
        for number, name in enumerate(NAMES)
    }
    torques = [
        estimate_torque(number, ended, information, at_bound) if each.voluntary else None
        for number, each in enumerate(problem.movements)
    ]
    ratios = estimate_ratios(problem, ended, information)
    return FitResult(
        parameters=with_reasons(parameters, not np.isfinite(belief.limits.reach)),
        ratios=ratios,
        segments=[
            segment_fit(problem, ended, number, torque) for number, torque in enumerate(torques)
        ],
        multistart=report(problem, ended),
        loss=float(best.loss[0]),
        noise_scale=ended.noise_scale,
        torque_frequency=reading,
        other_reading_rmse=other_rmse,
        prior=problem.belief.note,
        notes=notes(problem, ended, at_bound),
    )


def parameter_estimate(
    name: str,
    belief: Belief,
    value: float,
    information: Information,
    gradient: np.ndarray,
    at_bound: set[str],
) -> Estimate:
    """One of m, J, l, d, c, with what determined it or why nothing did."""
    declared = dict(declarations(LegParameters))[name]
    expected = None if belief.expected is None else getattr(belief.expected, name)
    deviation = np.inf
    if expected is not None:
        given = float(getattr(belief.prior.standard_deviation, name))
        deviation = given / np.sqrt(float(belief.prior.weight))
    error = information.standard_error(gradient)
    found = source(information, gradient, deviation, name in at_bound)
    held = name in at_bound or error == 0.0
    lower, upper = (
        float(getattr(limit, name)) for limit in (belief.limits.lower, belief.limits.upper)
    )
    if name in at_bound:  # the solver meets a bound to rounding; the bound itself is meant
        value = lower if abs(value - lower) < abs(value - upper) else upper
    return Estimate(
        symbol=declared.symbol,
        title=declared.title,
        unit=declared.unit,
        value=None if found is None else value,
        standard_error=None if found is None or held else error,
        expected=None if expected is None else expected.value,
        expected_deviation=None if expected is None else deviation,
        lower=lower if np.isfinite(lower) else None,
        upper=upper if np.isfinite(upper) else None,
        determined_by=found,
        reason="at a bound: no error is quoted" if held else None,
    )


def with_reasons(parameters: dict[str, Estimate], rig: bool) -> dict[str, Estimate]:
    """Say of every missing value why it is missing."""
    scale_known = parameters["inertia"].value is not None

    def why(name: str) -> str:
        if scale_known and name in ("mass", "com_distance"):
            return MASS_AND_DISTANCE
        return SCALE_FREE_RIG if rig else SCALE_FREE

    return {
        name: replace(each, reason=why(name)) if each.value is None else each
        for name, each in parameters.items()
    }


def estimate_torque(number: int, ended: Ended, information: Information, at_bound) -> Estimate:
    """tau of one voluntary segment."""
    declared = dict(declarations(CycleTorque))["amplitude"]
    gradient = ended.local.parameters[len(NAMES) + number]
    held = f"torque_amplitude[{number}]" in at_bound
    found = source(information, gradient, np.inf, held)
    known = found is not None
    return Estimate(
        symbol=declared.symbol,
        title=declared.title,
        unit=declared.unit,
        value=float(ended.best.torque[0, number]) if known else None,
        standard_error=information.standard_error(gradient) if known and found != "bound" else None,
        lower=declared.lower,
        upper=declared.upper,
        determined_by=found,
        reason=None if known else SCALE_FREE,
    )


def estimate_ratios(problem: Problem, ended: Ended, information: Information) -> dict[str, Estimate]:
    """m l g / J, c / J, d / J, and tau / J as the mean over the voluntary segments."""
    best = ended.best
    shared = best.coordinates.shared
    values = [shared.gravity[0], shared.stiffness[0], shared.damping[0]]
    gradients = list(ended.local.ratios[:3])
    voluntary = [number for number, each in enumerate(problem.movements) if each.voluntary]
    if voluntary:
        values.append(best.coordinates.own.torque[0, voluntary].mean())
        gradients.append(ended.local.ratios[[3 + number for number in voluntary]].mean(axis=0))
    estimates = {}
    for (name, (symbol, unit, title)), value, gradient in zip(
        list(RATIOS.items())[: len(values)], values, gradients, strict=True
    ):
        error = information.standard_error(gradient)
        estimates[name] = Estimate(
            symbol, title, unit, float(value), error if np.isfinite(error) and error > 0 else None
        )
    return estimates


def segment_fit(
    problem: Problem, ended: Ended, number: int, torque: Estimate | None
) -> SegmentFit:
    """Measured against simulated, at the samples that were fitted."""
    each, seen = problem.movements[number], problem.observation
    rows = np.searchsorted(np.asarray(seen.time[number]), each.segment.time)
    angle = ended.best.angle[0, number][rows]
    velocity = ended.best.angular_velocity[0, number][rows]
    gyro = each.angular_velocity
    return SegmentFit(
        name=each.name,
        kind=each.kind,
        period=each.period if each.voluntary else None,
        torque_amplitude=torque,
        added_mass=each.added_mass,
        angle_rmse=root_mean_square(angle - each.angle),
        velocity_rmse=None if gyro is None else root_mean_square(velocity - gyro),
        angle_noise=each.angle_noise,
        velocity_noise=None if gyro is None else each.velocity_noise,
        time=each.segment.time,
        angle=each.angle,
        angular_velocity=gyro,
        simulated_angle=angle,
        simulated_velocity=velocity,
    )


def root_mean_square(samples: np.ndarray) -> float:
    return float(np.sqrt(np.nanmean(samples**2)))


def report(problem: Problem, ended: Ended) -> MultistartReport:
    """How many starts arrived where, and the sets that fit as well as the chosen one."""
    reached = ended.member >= 0
    loss = np.where(reached, finite(ended.free.loss)[ended.member], np.inf)
    at_best = loss <= loss.min() * (1 + SAME_LOSS)
    free = finite(ended.free.loss)
    family, members = equally_good(problem, ended, np.flatnonzero(at_best))
    return MultistartReport(
        starts=ended.member.size,
        succeeded=int(reached.sum()),
        at_best=int(at_best.sum()),
        loss=loss,
        failures=ended.failures,
        family=family,
        members=members,
        distinct=len(np.unique(np.round(np.log(free[np.isfinite(free)]), 3))),
    )


def equally_good(problem: Problem, ended: Ended, rows: np.ndarray):
    """The range of every parameter at the chosen ratios within the limits, and a set per start.

    At given ratios each J leaves an interval of l (with m = J (m l / J) / l), so the exact ranges
    follow one by one; each start's set is its own J and l, moved into those intervals.
    """
    limits, shared = problem.belief.limits, ended.best.coordinates.shared
    moment = float(shared.gravity[0]) / GRAVITY  # m l / J
    if not np.isfinite(limits.reach) or moment <= 0:
        return {}, {}
    low, high = limits.lower, limits.upper
    longest = min(float(high.com_distance), 1 / moment)  # Eq. 12
    inertia = inertia_range(problem, ended, moment, longest)
    if inertia[0] > inertia[1]:
        return {}, {}
    shortest = float(low.com_distance)
    lightest, heaviest = float(low.mass), float(high.mass)
    stiffness, damping = float(shared.stiffness[0]), float(shared.damping[0])
    length = (
        max(shortest, moment * inertia[0] / heaviest),
        min(longest, moment * inertia[1] / lightest),
    )
    family = {
        "mass": (max(lightest, moment * inertia[0] / longest), min(heaviest, moment * inertia[1] / shortest)),
        "inertia": inertia,
        "com_distance": length,
        "damping": (damping * inertia[0], damping * inertia[1]),
        "stiffness": (stiffness * inertia[0], stiffness * inertia[1]),
    }
    start = ended.starts
    each = np.clip(np.exp(start.shared.log_inertia[rows]), *inertia)
    wish = start.shared.gravity[rows] * np.exp(start.shared.log_inertia - start.log_mass)[rows] / GRAVITY
    distance = np.clip(
        wish,
        np.maximum(shortest, moment * each / heaviest),
        np.minimum(longest, moment * each / lightest),
    )
    members = {
        "mass": moment * each / distance,
        "inertia": each,
        "com_distance": distance,
        "damping": damping * each,
        "stiffness": stiffness * each,
    }
    return family, members


def inertia_range(
    problem: Problem, ended: Ended, moment: float, longest: float
) -> tuple[float, float]:
    """The inertias that all limits allow at the chosen ratios; one value where J is known."""
    chosen = float(ended.best.leg.inertia[0])
    if (problem.known[:, 0] == 0).any():
        return chosen, chosen
    limits, best = problem.belief.limits, ended.best.coordinates
    lower = [float(limits.lower.inertia), float(limits.lower.mass * limits.lower.com_distance) / moment]
    upper = [float(limits.upper.inertia), float(limits.upper.mass) * longest / moment]
    for ratio, low, high in (
        (best.shared.stiffness[0], limits.lower.stiffness, limits.upper.stiffness),
        (best.shared.damping[0], limits.lower.damping, limits.upper.damping),
    ):
        if ratio > 0:
            lower.append(float(low / ratio))
            upper.append(float(high / ratio))
    torque = float(np.abs(best.own.torque[0]).max())
    if torque > 0:
        upper.append(float(limits.torque) / torque)
    return max(lower), min(upper)


def notes(problem: Problem, ended: Ended, at_bound: set[str]) -> list[str]:
    """What the user should know, in sentences."""
    said = []
    if ended.noise_scale > 1.2:
        said.append(
            f"the residual is larger than the sensors' noise: standard errors are widened "
            f"{ended.noise_scale:.3g} times. Something is missing in the model or in the noise level."
        )
    if float(ended.best.violation[0]) > FEASIBLE:
        said.append("the limits could not all be met: see the bounds in the table.")
    for rule in ("m l^2 <= J", "J <= reach m l"):
        if rule in at_bound:
            said.append(f"the fit lies on the limit {rule} of a rigid leg.")
    return said
