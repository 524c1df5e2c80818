"""From where a search ended to values with errors, units and reasons."""

from dataclasses import replace
from functools import partial

import numpy as np

from exoid.fitting.model.coordinates import leg_parameters, with_inertia
from exoid.fitting.multistart.search_result import SearchResult
from exoid.fitting.result.agreement import EXPLAINED, astray, believed, over_noise
from exoid.fitting.result.describing.doubts import doubted
from exoid.fitting.result.describing.leg import of_leg
from exoid.fitting.result.describing.notes import LeftOpen, notes
from exoid.fitting.result.describing.segment import segment_fit
from exoid.fitting.result.describing.starts import report
from exoid.fitting.result.estimates.basis import Basis
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.estimates.gainless import whatever_gain
from exoid.fitting.result.estimates.information import information_at, leans
from exoid.fitting.result.estimates.moved import moved
from exoid.fitting.result.estimates.scale import goes_with_scale, with_reasons
from exoid.fitting.result.estimates.terms import estimate_terms
from exoid.fitting.result.estimates.torque import estimate_torque
from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.result.mountings import beyond_belief, estimate_mountings, numbers_at
from exoid.fitting.result.remarks.limit_remarks import limits_met
from exoid.fitting.result.remarks.pushed.missed_law import missed_law
from exoid.fitting.result.remarks.rig_words import of_rig
from exoid.fitting.result.segment_fit import SegmentFit, pooled
from exoid.fitting.result.untold import with_slack
from exoid.fitting.solve.problem import Problem
from exoid.recordings.conventions.jumps import jumping

UNSETTLED = "the search was still moving when its steps ran out"


def describe(
    problem: Problem, ended: SearchResult, reading: str | None, other_rmse: float | None
) -> FitResult:
    """The numbers with their errors, units and reasons."""
    ended = whatever_gain(problem, ended)
    best, leaning = ended.best, leans(problem, ended)
    at_bound = {name for name, hold in zip(problem.constraints, leaning, strict=True) if hold}
    basis = Basis(problem, ended, information_at(problem, ended, leaning))
    law = missed_law(problem, ended, basis.information.open)
    off = moved(problem, ended, basis.information, None if law is None else law.steps)
    leg = of_leg(basis, at_bound, off)
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
        mountings=estimate_mountings(basis, off),
        multistart=report(problem, ended, leg.ratios),
        loss=float(best.loss[0]),
        disturbance=ended.disturbance,
        torque_frequency=reading,
        other_reading_rmse=other_rmse,
        prior=problem.belief.note,
        terms=estimate_terms(basis, at_bound, inertia, off),
        leg=leg_parameters(ended.point, np),
        thigh_angle=float(problem.movements[0].thigh_angle),
        fitted_terms=with_inertia(ended.point, np),
        notes=[],
        astray=why_astray(problem, ended, segments, at_bound),
        basis=basis,
    )
    told, rate, slack = doubted(result, basis, leg, partial(numbers_at, problem))
    said = notes(told, basis, at_bound, LeftOpen(rate, slack, law))
    return with_slack(replace(told, notes=said), slack)


def why_astray(
    problem: Problem, ended: SearchResult, segments: list[SegmentFit], at_bound: set[str]
) -> str | None:
    """Why the fit does not follow the recording, or should not; None where it does."""
    why = jumping({each.name: each.jumps for each in problem.movements})
    if why is None:
        why = astray(believed(segments, ended.disturbance), limits_met(problem, at_bound))
    if why is None:
        explained = pooled(segments, over_noise) < EXPLAINED
        why = beyond_belief(problem, ended, explained=explained)
    why = UNSETTLED if why is None and ended.best.exhausted[0] else why
    return of_rig(why) if why and problem.belief.rig else why
