"""From where a search ended to values with errors, units and reasons."""

import numpy as np

from exoid.fit.belief import NAMES
from exoid.fit.constraint import constraint_names
from exoid.fit.estimates import (
    estimate_ratios,
    estimate_torque,
    parameter_estimate,
    with_reasons,
)
from exoid.fit.family import equally_good
from exoid.fit.mountings import estimate_mountings
from exoid.fit.multistart import SAME_LOSS, Ended
from exoid.fit.problem import Problem, finite
from exoid.fit.remarks import remarks, strayed
from exoid.fit.result import (
    Basis,
    Estimate,
    FitResult,
    MultistartReport,
    SegmentFit,
)
from exoid.fit.uncertainty import Information


def describe(
    problem: Problem, ended: Ended, reading: str | None, other_rmse: float | None
) -> FitResult:
    """The numbers with their errors, units and reasons."""
    best, local = ended.best, ended.local
    names = constraint_names(len(problem.movements))
    belief = problem.belief
    fixed = np.array([name in belief.by_hand.fix for name in names])
    active = (best.multiplier[0] > 0) & ~fixed
    fixed[len(NAMES) :] = False  # both its ends are one
    information = Information(
        data=local.data,
        prior=local.prior,
        active=local.constraints[active | fixed],
        fixed=local.constraints[fixed],
    )
    at_bound = {name for name, hold in zip(names, active, strict=True) if hold}
    parameters = {
        name: parameter_estimate(name, belief, float(value), information, gradient, at_bound)
        for name, value, gradient in zip(NAMES, best.quantities[0], local.quantities, strict=False)
    }
    strongest = float(belief.limits.torque)

    def told(numbers: list[int]) -> Estimate:
        return estimate_torque(numbers, ended, information, at_bound, strongest)

    voluntary = [number for number, each in enumerate(problem.movements) if each.voluntary]
    torques = [
        told([number]) if each.voluntary else None for number, each in enumerate(problem.movements)
    ]
    segments = [
        segment_fit(problem, ended, number, torque) for number, torque in enumerate(torques)
    ]
    return FitResult(
        parameters=with_reasons(parameters, not np.isfinite(belief.limits.reach)),
        ratios=estimate_ratios(problem, ended, information, at_bound),
        torque_amplitude=told(voluntary) if voluntary else None,
        segments=segments,
        mountings=estimate_mountings(problem, ended, information),
        multistart=report(problem, ended),
        loss=float(best.loss[0]),
        disturbance=ended.disturbance,
        torque_frequency=reading,
        other_reading_rmse=other_rmse,
        prior=problem.belief.note,
        notes=[*strayed(segments, belief.raw), *remarks(problem, ended, at_bound)],
        basis=Basis(problem, ended, information),
    )


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
