"""From where a search ended to values with errors, units and reasons."""

from dataclasses import replace

import numpy as np

from exoid.fit.belief import NAMES, Belief
from exoid.fit.constraint import constraint_names
from exoid.fit.family import equally_good
from exoid.fit.multistart import FEASIBLE, SAME_LOSS, Ended, Problem, finite
from exoid.fit.result import Estimate, FitResult, MultistartReport, SegmentFit
from exoid.fit.uncertainty import Information, source
from exoid.physics.leg import LegParameters
from exoid.physics.parameter import declarations
from exoid.physics.torque import CycleTorque

MISFIT = 1.2  # widening of the errors from which the model does not explain the data
NO_RATIO = 1e-3  # a ratio below it, at a bound of zero, is the rounding of the bound
RATIOS = {  # name: symbol, title, unit
    "gravity_over_inertia": ("m l g / J", "gravity over inertia", "1/s^2"),
    "stiffness_over_inertia": ("c / J", "stiffness over inertia", "1/s^2"),
    "damping_over_inertia": ("d / J", "damping over inertia", "1/s"),
    "torque_over_inertia": ("tau / J", "torque over inertia", "1/s^2"),
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
    segments = len(problem.movements)
    names = constraint_names(segments)
    active = best.multiplier[0] > 0
    information = Information(data=local.data, prior=local.prior, active=local.constraints[active])
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
    ratios = estimate_ratios(problem, ended, information, at_bound)
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
        weight = float(belief.prior.weight)
        deviation = given / np.sqrt(weight) if weight > 0 else np.inf
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
        expected_deviation=deviation if np.isfinite(deviation) else None,
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


def estimate_ratios(
    problem: Problem, ended: Ended, information: Information, at_bound: set[str]
) -> dict[str, Estimate]:
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
    for name, value, gradient in zip(RATIOS, values, gradients, strict=False):
        error = information.standard_error(gradient)
        held = error == 0.0 or name.removesuffix("_over_inertia") in at_bound & {"damping"}
        estimates[name] = Estimate(
            *RATIOS[name],
            value=0.0 if held and abs(value) < NO_RATIO else float(value),
            standard_error=None if held or not np.isfinite(error) else error,
            reason="at a bound: no error is quoted" if held else None,
        )
    return estimates


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


def notes(problem: Problem, ended: Ended, at_bound: set[str]) -> list[str]:
    """What the user should know, in sentences."""
    said = []
    guessed = [each for each in problem.movements if not each.kind_said]
    if guessed:
        each = ", ".join(f"{one.name} {one.kind}" for one in guessed)
        said.append(f"the sidecar does not say how the leg was moved; by its motion: {each}.")
    if ended.noise_scale > MISFIT:
        said.append(
            "the residual is larger than the sensors' noise and not random: the model misses "
            "something, or the noise level is wrong. Standard errors are widened "
            f"{ended.noise_scale:.3g} times, for its size and for how slowly it varies; --plot "
            "shows where it is."
        )
        if np.isfinite(problem.belief.limits.reach):
            said.append(
                "m l g / J and c / J hold for a spring that is slack at full extension (Eq. 9). "
                "With another rest angle they trade off against each other by more than their "
                "errors say: drops from several angles, or with a known mass, tell them apart."
            )
    if not np.isfinite(problem.belief.limits.reach):
        said.append(
            "on a rig the spring term c phi also takes up a constant torque and an encoder zero "
            "that is off: read c / J as a spring only where a spring is known to be."
        )
    if float(ended.best.violation[0]) > FEASIBLE:
        said.append("the limits could not all be met: see the bounds in the table.")
    for rule in ("m l^2 <= J", "J <= reach m l"):
        if rule in at_bound:
            said.append(f"the fit lies on the limit {rule} of a rigid leg.")
    return said
