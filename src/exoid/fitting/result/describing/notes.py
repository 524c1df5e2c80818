"""What the user should know of a fit."""

from dataclasses import dataclass

from exoid.fitting.result.agreement import of_the_rest, of_unlike
from exoid.fitting.result.estimates.basis import Basis
from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.result.refused.notes import of_refused
from exoid.fitting.result.remarks.added_mass_remarks import of_misplaced, of_under_load
from exoid.fitting.result.remarks.anatomy_remarks import of_anatomy
from exoid.fitting.result.remarks.doubted_times import as_told
from exoid.fitting.result.remarks.noise_remarks import of_leg_tone, tone_of
from exoid.fitting.result.remarks.pushed.missed_law import MissedLaw, of_law
from exoid.fitting.result.remarks.remarks import remarks
from exoid.fitting.result.remarks.residual_remarks import of_unlike_drops
from exoid.fitting.result.remarks.rig_words import of_rig
from exoid.fitting.result.remarks.scale_remarks import of_scale
from exoid.fitting.result.remarks.zero.far_zeros import of_far_zeros
from exoid.fitting.result.remarks.zero.leaning import Leaning
from exoid.fitting.result.remarks.zero.slack_angle import shown_slack
from exoid.fitting.result.remarks.zero.slack_words import slack_angle_remarks
from exoid.fitting.result.systematics.granted import granted
from exoid.fitting.result.systematics.limiting import limiting
from exoid.fitting.result.systematics.suspicions import suspicions

WIDENED = "Errors are widened for it: record the leg without it, if that can be."


@dataclass(frozen=True, eq=False)
class LeftOpen:
    """What a recording leaves open of a fit."""

    rate: float  # the share by which its times may be off
    slack: Leaning | None  # for where the knee's spring is slack
    law: MissedLaw | None  # of what is missed


def notes(result: FitResult, basis: Basis, at_bound: set[str], left: LeftOpen) -> list[str]:
    """What the user should know of a fit, in the words of its leg or rig; of one that does not
    follow what does not hang on it.
    """
    problem = basis.problem
    if result.astray is not None:
        shown = shown_slack(problem, basis.ended, basis.information.open)
        said = of_refused(result.astray, basis, shown)
    else:
        said = of_a_fit(result, basis, at_bound, left)
    return [of_rig(each) for each in said] if problem.belief.rig else said


def of_a_fit(result: FitResult, basis: Basis, at_bound: set[str], left: LeftOpen) -> list[str]:
    """What is said of one that follows its recording, the most important first."""
    problem, ended = basis.problem, basis.ended
    rate, slack = left.rate, left.slack
    known = [*limiting(result), *granted(problem, doubted={"clock"} if rate else set())]
    gravity, times = float(ended.point.shared.gravity), as_told(problem, rate)
    tone = tone_of(result.segments)
    inertia = result.parameters["inertia"].value
    swung = [] if tone is None else [f"{of_leg_tone(tone, result.ratios, inertia)}. {WIDENED}"]
    return [
        *of_misplaced(problem, ended),
        *of_under_load(problem, ended),
        *of_anatomy(problem.belief, gravity, slack, times),
        *of_the_rest(result.segments, ended.disturbance),
        *of_unlike(result.segments, ended.disturbance),
        *of_unlike_drops(result.segments),
        *swung,
        *remarks(problem, ended, at_bound, inertia, swung=bool(swung)),
        *of_law(left.law, problem, ended),
        *of_scale(result.parameters, result.segments),
        *of_far_zeros(problem, ended),
        *slack_angle_remarks(slack),
        *suspicions(problem, result.mountings, ended),
        *known,
    ]
