"""From where a search ended to values with errors, units and reasons."""

from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from exoid.fitting.model.belief import NAMES
from exoid.fitting.model.coordinates import leg_parameters, with_inertia
from exoid.fitting.multistart.at_odds import at_odds
from exoid.fitting.multistart.gross_errors import hung_elsewhere, slanted
from exoid.fitting.multistart.pulled_by_declared import led_astray
from exoid.fitting.multistart.search_result import SAME_LOSS, SearchResult
from exoid.fitting.result.agreement import (
    astray,
    believed,
    of_the_rest,
    of_unlike,
    root_mean_square,
    simulated,
)
from exoid.fitting.result.equally_good import equally_good
from exoid.fitting.result.estimates.basis import Basis
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.estimates.found import mean_of
from exoid.fitting.result.estimates.gainless import whatever_gain, why_none
from exoid.fitting.result.estimates.information import information_at, leans
from exoid.fitting.result.estimates.parameters import parameter_estimate
from exoid.fitting.result.estimates.ratios import (
    estimate_moment,
    estimate_ratios,
    label_of,
    none_of,
)
from exoid.fitting.result.estimates.scale import goes_with_mass, goes_with_scale, with_reasons
from exoid.fitting.result.estimates.terms import estimate_terms
from exoid.fitting.result.estimates.torque import estimate_torque
from exoid.fitting.result.estimates.torque_zero import moved_by_torque_zero, off_by
from exoid.fitting.result.find_conditions import find_conditions
from exoid.fitting.result.fit_result import FitResult, MountingFit, MultistartReport
from exoid.fitting.result.limiting_systematics import granted, limiting, suspicions
from exoid.fitting.result.mountings import beyond_belief, estimate_mountings, numbers_at
from exoid.fitting.result.refused.notes import of_refused
from exoid.fitting.result.remarks.added_mass_remarks import misplaced, of_misplaced
from exoid.fitting.result.remarks.anatomy_remarks import SWING, of_anatomy
from exoid.fitting.result.remarks.doubted_times import as_told, doubted_rate, off_by_times
from exoid.fitting.result.remarks.limit_remarks import limits_met
from exoid.fitting.result.remarks.noise_remarks import of_leg_tone, tone_of
from exoid.fitting.result.remarks.remarks import remarks
from exoid.fitting.result.remarks.rig_words import of_rig
from exoid.fitting.result.remarks.scale_remarks import of_scale
from exoid.fitting.result.remarks.zero.far_zeros import of_far_zeros
from exoid.fitting.result.remarks.zero.leaning import LEANING, Leaning
from exoid.fitting.result.remarks.zero.slack_angle import left_open, slack_angle_remarks
from exoid.fitting.result.segment_fit import SegmentFit
from exoid.fitting.result.untold import (
    doubted_scale,
    with_slack,
    with_times,
    without_bare,
    without_lost,
    without_scale,
)
from exoid.fitting.solve.ask import finite
from exoid.fitting.solve.problem import Problem
from exoid.recordings.conventions.jumps import jumping

DISTANCE = "added_mass_distance"  # as it is called outside
UNFINISHED = "it was still moving when its steps ran out"
WIDENED = "Errors are widened for it: record the leg without it, if that can be."
UNSETTLED = "the search was still moving when its steps ran out"


def describe(
    problem: Problem, ended: SearchResult, reading: str | None, other_rmse: float | None
) -> FitResult:
    """The numbers with their errors, units and reasons."""
    ended = whatever_gain(problem, ended)
    best, leaning = ended.best, leans(problem, ended)
    at_bound = {name for name, hold in zip(problem.constraints, leaning, strict=True) if hold}
    basis = Basis(problem, ended, information_at(problem, ended, leaning))
    moved = moved_by_torque_zero(problem, ended)
    leg = of_leg(basis, at_bound, moved)
    inertia = leg.parameters["inertia"]

    def torque(names: list[str]) -> Estimate:
        own = estimate_torque(basis, names, at_bound)
        return goes_with_scale(own, leg.ratios["torque_over_inertia"], inertia)

    each_torque = problem.quantities_of("torque_amplitude")
    torques = dict(zip(problem.voluntary, ([name] for name in each_torque), strict=True))
    segments = [
        segment_fit(basis, number, torque(torques[number]) if number in torques else None)
        for number in range(len(problem.movements))
    ]
    result = FitResult(
        parameters=with_reasons(leg.parameters, problem.belief.rig),
        ratios=leg.ratios,
        torque_amplitude=torque(each_torque) if torques else None,
        segments=segments,
        mountings=estimate_mountings(basis, moved),
        multistart=report(problem, ended, leg.ratios),
        loss=float(best.loss[0]),
        disturbance=ended.disturbance,
        torque_frequency=reading,
        other_reading_rmse=other_rmse,
        prior=problem.belief.note,
        terms=estimate_terms(basis, at_bound, inertia, moved),
        leg=leg_parameters(ended.point, np),
        thigh_angle=float(problem.movements[0].thigh_angle),
        fitted_terms=with_inertia(ended.point, np),
        notes=[],
        astray=why_astray(problem, ended, segments, at_bound),
        basis=basis,
    )
    return with_doubts(result, basis, leg, at_bound)


@dataclass(frozen=True)
class OfLeg:
    """The leg's numbers, and the errors of m l g beside those of its factors."""

    ratios: dict[str, Estimate]
    parameters: dict[str, Estimate]
    moment_grown: float  # N m, with the error of m l g / J
    moment_by_distance: float  # N m, for an added mass that hangs elsewhere


def of_leg(basis: Basis, at_bound: set[str], moved: np.ndarray) -> OfLeg:
    """Ratios and parameters, wider by what the search cannot see: odds, declared values that led
    it, a slanted seat, a torque's zero that has `moved` it, an added mass that hangs elsewhere.
    """
    problem, ended = basis.problem, basis.ended
    plain, elsewhere = estimate_ratios(basis, at_bound), hung_elsewhere(problem, ended)
    odds, steps, beside = (
        at_odds(problem, ended),
        led_astray(problem, ended),
        slanted(problem, ended),
    )
    zeros = {
        name: off_by(moved, mean_of(basis, problem.quantities_of(name), set()).gradient)
        for name in plain
    }
    ratios = {
        name: each.widened(steps.get(name, 0.0), least=odds.get(name, 0.0))
        .widened(beside.get(name, 0.0), cause="tilt")
        .widened(zeros.get(name, 0.0), cause="torque_zero")
        .widened(elsewhere.get(name, 0.0), cause=DISTANCE)
        for name, each in plain.items()
    }
    parameters = {
        name: each.widened(elsewhere[name], cause=DISTANCE)
        for name, each in estimate_leg(basis, ratios, at_bound).items()
    }
    by_zero = off_by(moved, mean_of(basis, ["inertia"], set()).gradient)
    inertia = parameters["inertia"].widened(by_zero, cause="torque_zero")
    parameters["inertia"] = inertia
    grown = {name: growth(plain[name], each, inertia) for name, each in ratios.items()}
    for name in ("damping", "stiffness"):
        parameters[name] = parameters[name].widened(grown[f"{name}_over_inertia"])
    by_distance = elsewhere["inertia"] * (ratios[SWING].value or 0.0)
    return OfLeg(ratios, parameters, grown[SWING], by_distance)


def with_doubts(result: FitResult, basis: Basis, leg: OfLeg, at_bound: set[str]) -> FitResult:
    """The same without what the recording contradicts or does not tell, with m l g of what is left,
    with what stays open for times and for the knee's spring, and with its notes.
    """
    problem, ended = basis.problem, basis.ended
    told = without_bare(without_lost(result), problem)
    slack = open_for_slack(told, basis)
    doubt = why_none(problem) or doubted_scale(told, problem, misplaced(problem, ended), slack)
    if doubt is not None:
        told = without_scale(told, doubt)
    moment = estimate_moment(basis, told.ratios[SWING], told.parameters["inertia"])
    moment = moment.widened(leg.moment_grown).widened(leg.moment_by_distance, cause=DISTANCE)
    swing, rate = told.ratios[SWING], 0.0
    if told.follows and swing.value is not None:
        rate = doubted_rate(problem, swing.value, swing.standard_error or 0.0, slack)
    off = off_by_times(problem, ended, rate, partial(numbers_at, problem))
    told = with_times(replace(told, gravity_moment=moment), off)
    slack = open_for_slack(told, basis) if rate else slack
    said = notes(told, basis, at_bound, slack, rate)
    if problem.belief.rig:
        said = [of_rig(each) for each in said]
    return with_slack(replace(told, notes=said), slack)


def open_for_slack(result: FitResult, basis: Basis) -> Leaning | None:
    """What is left open for where the knee's spring is slack; None where that is less than ±."""
    if not result.follows:
        return None
    errors = {name: result.ratios[name].standard_error or 0.0 for name in LEANING}
    errors |= errors_of(result.mountings)
    numbers = partial(numbers_at, basis.problem)
    return left_open(basis.problem, basis.ended, basis.information.open, errors, numbers)


def errors_of(mountings: list[MountingFit]) -> dict[str, float]:
    """The standard errors of what recordings own, by recording and name, where there are."""
    return {
        f"{each.recording}.{name}": one.standard_error
        for each in mountings
        for name, one in each.known.items()
        if one.standard_error
    }


def growth(before: Estimate, after: Estimate, inertia: Estimate) -> float:
    """By how much the error of what is this ratio times J grows with that of the ratio."""
    errors = [each.standard_error or 0.0 for each in (before, after)]
    return (inertia.value or 0.0) * float(np.sqrt(max(errors[1] ** 2 - errors[0] ** 2, 0.0)))


def notes(
    result: FitResult,
    basis: Basis,
    at_bound: set[str],
    slack: Leaning | None,
    rate: float,
) -> list[str]:
    """What the user should know of a fit, whose times may be off by a share `rate`; of one that
    does not follow what does not hang on it.
    """
    problem, ended = basis.problem, basis.ended
    if result.astray is not None:
        return of_refused(result.astray, problem, ended)
    known = [*limiting(result), *granted(problem, doubted={"clock"} if rate else set())]
    gravity, times = float(ended.point.shared.gravity), as_told(problem, rate)
    tone = tone_of(result.segments)
    inertia = result.parameters["inertia"].value
    swung = [] if tone is None else [f"{of_leg_tone(tone, result.ratios, inertia)}. {WIDENED}"]
    return [
        *of_misplaced(problem, ended),
        *of_anatomy(problem.belief, gravity, slack, times),
        *of_the_rest(result.segments, ended.disturbance),
        *of_unlike(result.segments, ended.disturbance),
        *swung,
        *remarks(problem, ended, at_bound, inertia, swung=bool(swung)),
        *of_scale(result.parameters, result.segments),
        *of_far_zeros(problem, ended),
        *slack_angle_remarks(slack),
        *suspicions(problem, result.mountings, ended),
        *known,
    ]


def estimate_leg(
    basis: Basis, ratios: dict[str, Estimate], at_bound: set[str]
) -> dict[str, Estimate]:
    """m, J, l, d, c; the last two go with J where motion tells no more than their ratio to it."""
    belief = basis.problem.belief
    parameters = {
        name: parameter_estimate(name, belief, mean_of(basis, [name], at_bound)) for name in NAMES
    }
    distance, mass = parameters["com_distance"], parameters["mass"]
    parameters["com_distance"] = goes_with_mass(distance, mass)
    for name in ("damping", "stiffness"):
        if name in basis.problem.absent:
            parameters[name] = none_of(label_of(parameters[name]))
            continue
        ratio = ratios[f"{name}_over_inertia"]
        parameters[name] = goes_with_scale(parameters[name], ratio, parameters["inertia"])
    return parameters


def why_astray(
    problem: Problem, ended: SearchResult, segments: list[SegmentFit], at_bound: set[str]
) -> str | None:
    """Why the fit does not follow the recording, or should not; None where it does."""
    why = jumping({each.name: each.jumps for each in problem.movements})
    if why is None:
        why = astray(believed(segments, ended.disturbance), limits_met(problem, at_bound))
    why = beyond_belief(problem, ended) if why is None else why
    why = UNSETTLED if why is None and ended.best.exhausted[0] else why
    return of_rig(why) if why and problem.belief.rig else why


def segment_fit(basis: Basis, number: int, torque: Estimate | None) -> SegmentFit:
    """Measured against simulated, at the samples that were fitted."""
    best, each = basis.ended.best, basis.problem.movements[number]
    angle = simulated(basis.problem, best.angle, number)
    velocity = simulated(basis.problem, best.angular_velocity, number)
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
        conditions=find_conditions(basis.problem, basis.ended, number),
        left_out=each.slow,
        caught=each.caught,
    )


def report(problem: Problem, ended: SearchResult, ratios: dict[str, Estimate]) -> MultistartReport:
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
    family, members = equally_good(problem, ended, np.flatnonzero(at_best), ratios)
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
