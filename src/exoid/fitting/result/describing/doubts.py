"""What the recording contradicts, does not tell, or leaves open."""

from dataclasses import replace

from exoid.fitting.result.describing.leg_numbers import DISTANCE, LegNumbers
from exoid.fitting.result.estimates.basis import Basis
from exoid.fitting.result.estimates.gainless import why_none
from exoid.fitting.result.estimates.ratios import estimate_moment
from exoid.fitting.result.fit_result import FitResult, MountingFit
from exoid.fitting.result.remarks.added_mass_remarks import misplaced
from exoid.fitting.result.remarks.anatomy_remarks import SWING
from exoid.fitting.result.remarks.doubted_times import doubted_rate, off_by_times
from exoid.fitting.result.remarks.pushed.answer import Numbers
from exoid.fitting.result.remarks.zero.leaning import LEANING, Leaning
from exoid.fitting.result.remarks.zero.slack_angle import left_open
from exoid.fitting.result.untold import (
    doubted_scale,
    with_times,
    without_bare,
    without_lost,
    without_scale,
)


def doubted(
    result: FitResult, basis: Basis, leg: LegNumbers, numbers: Numbers
) -> tuple[FitResult, float, Leaning | None]:
    """A result without what the recording contradicts or does not tell, with m l g of what is left;
    the share by which its times may be off; and what stays open for the knee's spring.
    `numbers` are a result's at a point, by their names.
    """
    problem, ended = basis.problem, basis.ended
    told = without_bare(without_lost(result), problem)
    slack = open_for_slack(told, basis, numbers)
    doubt = why_none(problem) or doubted_scale(told, problem, misplaced(problem, ended), slack)
    if doubt is not None:
        told = without_scale(told, doubt)
    moment = estimate_moment(basis, told.ratios[SWING], told.parameters["inertia"])
    moment = moment.widened(leg.moment_grown).widened(leg.moment_by_distance, cause=DISTANCE)
    swing, rate = told.ratios[SWING], 0.0
    if told.follows and swing.value is not None:
        rate = doubted_rate(problem, swing.value, swing.standard_error or 0.0, slack)
    off = off_by_times(problem, ended, rate, numbers)
    told = with_times(replace(told, gravity_moment=moment), off)
    return told, rate, open_for_slack(told, basis, numbers) if rate else slack


def open_for_slack(result: FitResult, basis: Basis, numbers: Numbers) -> Leaning | None:
    """What is left open for where the knee's spring is slack; None where that is less than ±."""
    if not result.follows:
        return None
    errors = {name: result.ratios[name].standard_error or 0.0 for name in LEANING}
    errors |= errors_of(result.mountings)
    return left_open(basis.problem, basis.ended, basis.information.open, errors, numbers)


def errors_of(mountings: list[MountingFit]) -> dict[str, float]:
    """The standard errors of what recordings own, by recording and name, where there are."""
    return {
        f"{each.recording}.{name}": one.standard_error
        for each in mountings
        for name, one in each.known.items()
        if one.standard_error
    }
