"""From where a search ended to values with errors, units and reasons."""

from dataclasses import replace

import numpy as np

from exoid.fit.belief import NAMES, Belief
from exoid.fit.constraint import constraint_names
from exoid.fit.coordinates import QUANTITIES, TYPICAL, flattened, unflattened
from exoid.fit.family import equally_good
from exoid.fit.multistart import SAME_LOSS, Ended
from exoid.fit.observation import places, remounts
from exoid.fit.problem import Problem, finite, take
from exoid.fit.remarks import remarks
from exoid.fit.result import (
    Basis,
    Estimate,
    FitResult,
    MountingFit,
    MultistartReport,
    SegmentFit,
)
from exoid.fit.uncertainty import HELD, Information, Shares
from exoid.physics.leg import LegParameters
from exoid.physics.parameter import declarations
from exoid.physics.torque import CycleTorque

NO_RATIO = 1e-3  # a ratio below it, at a bound of zero, is the rounding of the bound
ON_BOUND = "at a bound: no error is quoted"
NARROWED = "± holds only on the bound that made it known; inwards it is wider, as --plot shows"
RATIOS = {  # name: symbol, title, unit
    "gravity_over_inertia": ("m l g / J", "gravity over inertia", "1/s^2"),
    "stiffness_over_inertia": ("c / J", "stiffness over inertia", "1/s^2"),
    "damping_over_inertia": ("d / J", "damping over inertia", "1/s"),
    "torque_over_inertia": ("tau / J", "torque over inertia", "1/s^2"),
}
MOUNTING = {  # name: symbol, title, unit
    "added_mass_distance": ("r", "distance of the added mass from the knee", "m"),
    "zero": ("zero", "encoder zero against the first recording", "rad"),
    "gyro_scale": ("scale", "gyro scale against the first recording, less 1", "-"),
    "gyro_bias": ("bias", "gyro bias against the first recording", "rad/s"),
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


def describe(
    problem: Problem, ended: Ended, reading: str | None, other_rmse: float | None
) -> FitResult:
    """The numbers with their errors, units and reasons."""
    best, local = ended.best, ended.local
    names = constraint_names(len(problem.movements))
    active = best.multiplier[0] > 0
    information = Information(data=local.data, prior=local.prior, active=local.constraints[active])
    at_bound = {name for name, hold in zip(names, active, strict=True) if hold}
    belief = problem.belief
    parameters = {
        name: parameter_estimate(name, belief, float(value), information, gradient, at_bound)
        for name, value, gradient in zip(NAMES, best.quantities[0], local.quantities, strict=False)
    }
    voluntary = [number for number, each in enumerate(problem.movements) if each.voluntary]
    torques = [
        estimate_torque([number], ended, information, at_bound) if each.voluntary else None
        for number, each in enumerate(problem.movements)
    ]
    return FitResult(
        parameters=with_reasons(parameters, not np.isfinite(belief.limits.reach)),
        ratios=estimate_ratios(problem, ended, information, at_bound),
        torque_amplitude=estimate_torque(voluntary, ended, information, at_bound)
        if voluntary
        else None,
        segments=[
            segment_fit(problem, ended, number, torque) for number, torque in enumerate(torques)
        ],
        mountings=estimate_mountings(problem, ended, information),
        multistart=report(problem, ended),
        loss=float(best.loss[0]),
        disturbance=ended.disturbance,
        torque_frequency=reading,
        other_reading_rmse=other_rmse,
        prior=problem.belief.note,
        notes=remarks(problem, ended, at_bound),
        basis=Basis(problem, ended, information),
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
        weight = float(belief.prior.weight)
        deviation = given / np.sqrt(weight) if weight > 0 else np.inf
    shares = HELD if name in at_bound else information.shares(gradient)
    lower, upper = (
        float(getattr(limit, name)) for limit in (belief.limits.lower, belief.limits.upper)
    )
    if name in at_bound:  # the solver meets a bound to rounding; the bound itself is meant
        value = lower if abs(value - lower) < abs(value - upper) else upper
    quoted = shares is not None and shares != HELD
    return Estimate(
        symbol=declared.symbol,
        title=declared.title,
        unit=declared.unit,
        value=None if shares is None else value,
        standard_error=information.standard_error(gradient) if quoted else None,
        expected=None if expected is None else expected.value,
        expected_deviation=deviation if np.isfinite(deviation) else None,
        lower=lower if np.isfinite(lower) else None,
        upper=upper if np.isfinite(upper) else None,
        shares=shares,
        reason=ON_BOUND if shares == HELD else NARROWED if narrowed(shares) else None,
    )


def narrowed(shares: Shares | None) -> bool:
    """Is the error small only because a bound holds another quantity?"""
    return shares is not None and shares.source == "bound"


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


def estimate_torque(
    numbers: list[int], ended: Ended, information: Information, at_bound: set[str]
) -> Estimate:
    """The mean of tau over these voluntary segments."""
    declared = dict(declarations(CycleTorque))["amplitude"]
    rows = QUANTITIES + np.array(numbers)
    gradient = ended.local.quantities[rows].mean(axis=0)
    held = all(f"torque_amplitude[{number}]" in at_bound for number in numbers)
    shares = HELD if held else information.shares(gradient)
    known = shares is not None
    quoted = known and shares != HELD
    return Estimate(
        symbol=declared.symbol,
        title=declared.title,
        unit=declared.unit,
        value=float(ended.best.quantities[0, rows].mean()) if known else None,
        standard_error=information.standard_error(gradient) if quoted else None,
        lower=declared.lower,
        upper=declared.upper,
        shares=shares,
        reason=None if known else SCALE_FREE,
    )


def estimate_ratios(
    problem: Problem, ended: Ended, information: Information, at_bound: set[str]
) -> dict[str, Estimate]:
    """m l g / J, c / J, d / J, and tau / J as the mean over the voluntary segments."""
    first, end = len(NAMES), QUANTITIES
    values = list(ended.best.quantities[0, first:end])
    gradients = list(ended.local.quantities[first:end])
    voluntary = [number for number, each in enumerate(problem.movements) if each.voluntary]
    if voluntary:
        rows = end + len(problem.movements) + np.array(voluntary)
        values.append(ended.best.quantities[0, rows].mean())
        gradients.append(ended.local.quantities[rows].mean(axis=0))
    estimates = {}
    for name, value, gradient in zip(RATIOS, values, gradients, strict=False):
        held = name.removesuffix("_over_inertia") in at_bound & {"damping"}
        shares = HELD if held else information.shares(gradient)
        held = shares == HELD
        estimates[name] = Estimate(
            *RATIOS[name],
            value=0.0 if held and abs(value) < NO_RATIO else float(value),
            standard_error=None if held or shares is None else information.standard_error(gradient),
            shares=shares,
            reason=ON_BOUND if held else None,
        )
    return estimates


def estimate_mountings(
    problem: Problem, ended: Ended, information: Information
) -> list[MountingFit]:
    """What every recording owned, of what was to be estimated."""
    point = take(ended.best.coordinates, 0)
    number = unflattened(np.arange(flattened(point).size), point).mounting
    distances, others = places(problem.movements), remounts(problem.movements)

    def estimate(name: str, field: str, entry: int) -> Estimate:
        at = int(getattr(number, field)[entry])
        value = float(getattr(point.mounting, field)[entry])
        slope = float(getattr(TYPICAL.mounting, field))
        if field == "log_distance":
            value = float(np.exp(value))
            slope *= value
        gradient = slope * np.eye(flattened(point).size)[at]
        shares = information.shares(gradient)
        error = None if shares is None else information.standard_error(gradient)
        return Estimate(*MOUNTING[name], value=value, standard_error=error, shares=shares)

    def mounting(recording: int) -> MountingFit:
        name = next(each.source for each in problem.movements if each.recording == recording)
        placed, moved = recording in distances, recording in others
        return MountingFit(
            name,
            estimate("added_mass_distance", "log_distance", distances.index(recording))
            if placed
            else None,
            *(
                estimate(each, each, others.index(recording)) if moved else None
                for each in ("zero", "gyro_scale", "gyro_bias")
            ),
        )

    return [mounting(recording) for recording in sorted({*distances, *others})]


def segment_fit(problem: Problem, ended: Ended, number: int, torque: Estimate | None) -> SegmentFit:
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
