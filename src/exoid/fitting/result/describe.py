"""From where a search ended to values with errors, units and reasons."""

import numpy as np

from exoid.fitting.misfit.neighbourhood import columns, told
from exoid.fitting.misfit.uncertainty import Information, Pressed, decomposed, inverse_times
from exoid.fitting.model.belief import NAMES
from exoid.fitting.model.constraint import NEVER, violations_at
from exoid.fitting.model.coordinates import (
    flattened,
    leg_parameters,
    unflattened,
    with_inertia,
)
from exoid.fitting.multistart.ended import SAME_LOSS, Ended
from exoid.fitting.result.agreement import astray, believed, of_the_rest
from exoid.fitting.result.equally_good import equally_good
from exoid.fitting.result.estimates import (
    estimate_ratios,
    estimate_terms,
    estimate_torque,
    goes_with_scale,
    parameter_estimate,
    with_reasons,
)
from exoid.fitting.result.fit_result import (
    Basis,
    Estimate,
    FitResult,
    MultistartReport,
    SegmentFit,
)
from exoid.fitting.result.limiting_systematics import limiting, suspicions
from exoid.fitting.result.mountings import FIELDS, beyond_belief, estimate_mountings
from exoid.fitting.result.remarks import limits_met, of_astray, remarks
from exoid.fitting.solve.ask import around, finite, take
from exoid.fitting.solve.problem import Problem

UNFINISHED = "it was still moving when its steps ran out"
# Of half a chi-square for a typical step of what is limited: where nothing tells a value, a search
# may end on a limit that does not hold it back.
PRESSING = 1e-3
UNSETTLED = "the search was still moving when its steps ran out"


def describe(
    problem: Problem, ended: Ended, reading: str | None, other_rmse: float | None
) -> FitResult:
    """The numbers with their errors, units and reasons."""
    best, local = ended.best, ended.local
    names, belief = problem.constraints, problem.belief
    fixed = np.array([name in belief.by_hand.fix for name in names])
    leaning = (best.multiplier[0] > PRESSING) & ~fixed
    fixed &= [name not in names[:row] for row, name in enumerate(names)]  # both its ends are one
    information = Information(
        data=local.data + local.declared,
        prior=local.prior - local.declared,
        active=local.constraints[fixed],
        pressed=pressed_at(problem, ended, np.flatnonzero(leaning)),
        fixed=local.constraints[fixed],
        kinds=told_by_kind(problem, ended),
        owned=owned_places(problem, ended),
    )
    at_bound = {name for name, hold in zip(names, leaning, strict=True) if hold}
    parameters = {
        name: parameter_estimate(name, belief, float(value), information, gradient, at_bound)
        for name, value, gradient in zip(NAMES, best.quantities[0], local.quantities, strict=False)
    }
    ratios = estimate_ratios(problem, ended, information, at_bound)
    inertia = parameters["inertia"]
    for name in ("damping", "stiffness"):
        ratio = ratios[f"{name}_over_inertia"]
        parameters[name] = goes_with_scale(parameters[name], ratio, inertia)
    strongest = float(belief.limits.torque)

    def torque(numbers: list[int]) -> Estimate:
        own = estimate_torque(numbers, problem, ended, information, at_bound, strongest)
        return goes_with_scale(own, ratios["torque_over_inertia"], inertia)

    voluntary = [number for number, each in enumerate(problem.movements) if each.voluntary]
    torques = [
        torque([number]) if each.voluntary else None
        for number, each in enumerate(problem.movements)
    ]
    segments = [segment_fit(problem, ended, number, each) for number, each in enumerate(torques)]
    why = astray(believed(segments, ended.disturbance), limits_met(problem, at_bound))
    why = beyond_belief(problem, ended) if why is None else why
    why = UNSETTLED if why is None and best.exhausted[0] else why
    mountings = estimate_mountings(problem, ended, information)
    suspected = suspicions(problem, mountings, ended.disturbance)
    terms = estimate_terms(problem, ended, information, at_bound, inertia)
    systematic = [*suspected, *limiting({**parameters, **ratios})]
    return FitResult(
        parameters=with_reasons(parameters, not np.isfinite(belief.limits.reach)),
        ratios=ratios,
        torque_amplitude=torque(voluntary) if voluntary else None,
        segments=segments,
        mountings=mountings,
        multistart=report(problem, ended),
        loss=float(best.loss[0]),
        disturbance=ended.disturbance,
        torque_frequency=reading,
        other_reading_rmse=other_rmse,
        prior=problem.belief.note,
        terms=terms,
        leg=leg_parameters(take(best.coordinates, 0), np),
        thigh_angle=float(problem.movements[0].thigh_angle),
        fitted_terms=with_inertia(take(best.coordinates, 0), np),
        notes=[
            *of_astray(why, belief, len({each.recording for each in problem.movements}) > 1),
            *of_the_rest(segments, ended.disturbance),
            *remarks(problem, ended, at_bound),
            *systematic,
        ],
        astray=why,
        basis=Basis(problem, ended, information),
    )


def pressed_at(problem: Problem, ended: Ended, rows: np.ndarray) -> Pressed:
    """Limits that hold the best fit: how far beyond them it would be, by what it minimised."""
    best, gradients, names = ended.best, ended.local.constraints[rows], problem.constraints
    searched = around(problem, best)
    known = decomposed(searched.data + searched.prior)
    variance = np.array([each @ inverse_times(known, each) for each in gradients])
    values = violations_at(problem.belief.limits, take(best.coordinates, 0), np)

    def room(row: int) -> float:
        ends = [k for k, name in enumerate(names) if name == names[row] and k != row]
        return min((-values[k] for k in ends if values[k] != NEVER), default=np.inf)

    beyond = best.multiplier[0, rows] * variance
    return Pressed(gradients, beyond, np.array([room(row) for row in rows.tolist()]))


def owned_places(problem: Problem, ended: Ended) -> dict[str, np.ndarray]:
    """The coordinates of everything that recordings own, by its name."""
    point = take(ended.best.coordinates, 0)
    numbers = unflattened(np.arange(flattened(point).size), point).mounting
    free = {
        field: [
            n for entry, n in enumerate(getattr(numbers, field)) if problem.estimates(field, entry)
        ]
        for field in problem.owned
    }
    return {FIELDS[field]: np.array(at) for field, at in free.items() if at}


def told_by_kind(problem: Problem, ended: Ended) -> dict[str, np.ndarray]:
    """The weighed information of every kind of segment, where there are several."""
    point = take(ended.best.coordinates, 0)
    place, size = columns(point, problem.observation.seat), flattened(point).size
    found = {}
    for kind in dict.fromkeys(problem.kinds):
        own = np.array([each == kind for each in problem.kinds])
        condensed = take(take(ended.best.condensed, 0), own)
        found[kind] = told(condensed, place[own], size)
    return found if len(found) > 1 else {}


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
        begins=each.segment.begins,
    )


def root_mean_square(samples: np.ndarray) -> float:
    return float(np.sqrt(np.nanmean(samples**2)))


def report(problem: Problem, ended: Ended) -> MultistartReport:
    """How many starts arrived where, and the sets that fit as well as the chosen one.

    Who ran out of steps short of the best cost found no minimum, and did not succeed.
    """
    reached = ended.member >= 0
    free = finite(ended.free.loss)
    least = free[ended.member[reached]].min() * (1 + SAME_LOSS)
    moving = np.asarray(ended.free.exhausted) & (free > least)
    tired = reached & moving[ended.member]
    loss = np.where(reached, free[ended.member], np.inf)
    at_best = loss <= least
    family, members = equally_good(problem, ended, np.flatnonzero(at_best))
    minima = free[np.isfinite(free) & ~moving]
    return MultistartReport(
        starts=ended.member.size,
        succeeded=int((reached & ~tired).sum()),
        at_best=int(at_best.sum()),
        loss=loss,
        failures=ended.failures | ({UNFINISHED: int(tired.sum())} if tired.any() else {}),
        family=family,
        members=members,
        distinct=len(np.unique(np.round(np.log(minima), 3))),
    )
