"""What nothing tells where a kind of segment is not followed, or what weighs the leg is off.

And what stays open for where the knee's spring is slack.
"""

from collections.abc import Callable, Sequence
from dataclasses import replace
from math import sqrt

from exoid.fitting.misfit.uncertainty import HELD
from exoid.fitting.result.agreement import lost, unbelieved
from exoid.fitting.result.chief import chief
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.estimates.scale import (
    MISPLACED,
    SCALE_FREE,
    SCALE_FREE_RIG,
    TOGETHER,
    UNLESS_BENT,
    UNLIKE,
    without_value,
)
from exoid.fitting.result.fit_result import FitResult, MountingFit
from exoid.fitting.result.remarks.anatomy_remarks import SWING, bent_explains, unlike_anatomy
from exoid.fitting.result.remarks.zero.leaning import Leaning
from exoid.fitting.result.segment_fit import SegmentFit
from exoid.fitting.solve.problem import Problem

TORQUE = "torque_over_inertia"
NOTICED = 0.5  # errors of a number, from which on what is left open is told: 12 % of ± together
GOES = ("over", "times")  # J: what motion alone tells of a parameter that goes with it


def without_lost(result: FitResult) -> FitResult:
    """The same without the numbers that only segments tell which the simulation does not follow.

    A torque of another form than Eq. 10's leaves an amplitude, and no error says how wrong it is.
    """
    why = lost(result.segments, result.disturbance)
    if why is None:
        return result
    kinds = {each.kind for each in unbelieved(result.segments, result.disturbance)}
    driven = {each.kind for each in result.segments if each.torque_amplitude is not None}

    def kept(name: str, each: Estimate) -> Estimate:
        rests = each.shares is not None and each.shares.kind in kinds
        return without_value(each, why) if rests or (name == TORQUE and driven & kinds) else each

    def of_segment(each: SegmentFit) -> SegmentFit:
        torque = each.torque_amplitude
        if torque is None or each.kind not in kinds:
            return each
        return replace(each, torque_amplitude=without_value(torque, why))

    def of_all(each: dict[str, Estimate]) -> dict[str, Estimate]:
        return {name: kept(name, one) for name, one in each.items()}

    mean = result.torque_amplitude
    return replace(
        result,
        parameters=of_all(result.parameters),
        ratios=of_all(result.ratios),
        terms={term: of_all(own) for term, own in result.terms.items()},
        segments=[of_segment(each) for each in result.segments],
        torque_amplitude=without_value(mean, why) if mean is not None and driven & kinds else mean,
    )


def without_bare(result: FitResult, problem: Problem) -> FitResult:
    """The same without the ratios of what never moved without the same known mass on it, where
    nothing tells J: motion shows those of both together.
    """
    loads = {one.load for one in problem.movements}
    bare = len(loads) > 1 or not any(mass for mass, _ in loads)
    if bare or result.parameters["inertia"].value is not None:
        return result
    ratios = {
        name: each if each.value == 0 else without_value(each, TOGETHER)  # none, whatever J is
        for name, each in result.ratios.items()
    }
    return replace(result, ratios=ratios)


def doubted_scale(
    result: FitResult, problem: Problem, misplaced: Sequence[int], slack: Leaning | None
) -> str | None:
    """Why J, by which all but the ratios to it go, is none to be given; None where it is one.

    Where the distance of an added mass limits it, and is in doubt; where it leans on the anatomy of
    a body that the motion speaks against, be it only if its spring is not `slack` in a bent
    position.
    """
    inertia, gravity = result.parameters["inertia"], result.ratios[SWING]
    most = chief(inertia)
    if misplaced and most is not None and most[0].startswith("added_mass"):
        return MISPLACED
    if not result.follows or inertia.determined_by == "data" or gravity.value is None:
        return None
    error = gravity.standard_error or 0.0
    if bent_explains(problem.belief, gravity.value, slack, error):
        return UNLESS_BENT
    return UNLIKE if unlike_anatomy(problem.belief, gravity.value, error) else None


def without_scale(result: FitResult, why: str) -> FitResult:
    """The same without what goes with J: all but the ratios to it."""

    def kept(each: Estimate) -> Estimate:
        nothing = each.shares == HELD and not each.value  # whatever J is
        otherwise = each.shares is None and each.reason not in (SCALE_FREE, SCALE_FREE_RIG)
        known = each.by_hand == "fix" or otherwise or nothing  # or lost, for another reason
        return each if known else without_value(each, why)

    def of_term(own: dict[str, Estimate]) -> dict[str, Estimate]:
        scaled = {name for name in own if {f"{name}_{goes}_inertia" for goes in GOES} & own.keys()}
        return {name: kept(each) if name in scaled else each for name, each in own.items()}

    def of_segment(each: SegmentFit) -> SegmentFit:
        torque = each.torque_amplitude
        return replace(each, torque_amplitude=torque and kept(torque))

    mean = result.torque_amplitude
    return replace(
        result,
        parameters={name: kept(each) for name, each in result.parameters.items()},
        terms={term: of_term(own) for term, own in result.terms.items()},
        segments=[of_segment(each) for each in result.segments],
        torque_amplitude=mean and kept(mean),
        multistart=replace(result.multistart, family={}),  # which is of one J
    )


def with_slack(result: FitResult, found: Leaning | None) -> FitResult:
    """The result, each number with how far it is open for where the spring is slack."""
    return spread_over(result, {} if found is None else found.spread, if_slack)


def with_times(result: FitResult, off: dict[str, float]) -> FitResult:
    """The result, each number with an error that holds how far it may be `off` by wrong times."""
    return spread_over(result, off, lambda each, by: each.widened(by, cause="clock"))


def if_times_right(result: FitResult) -> Estimate:
    """m l g / J, its error without what `with_times` adds."""
    each, basis = result.ratios[SWING], result.basis
    if basis is None or basis.problem.times_vouched or each.standard_error is None:
        return each
    of_times = (each.limited_by or {}).get("clock", 0.0)
    return replace(each, standard_error=each.standard_error * sqrt(1 - of_times))


def spread_over(
    result: FitResult, far: dict[str, float], change: Callable[[Estimate, float], Estimate]
) -> FitResult:
    """The result with a `change` of each number by how `far` it may be off."""

    def told(known: dict[str, Estimate], of: str = "") -> dict[str, Estimate]:
        return {name: change(each, far.get(of + name, 0.0)) for name, each in known.items()}

    def of_recording(each: MountingFit) -> MountingFit:
        return replace(each, **told(each.known, f"{each.recording}."))

    moment, torque = result.gravity_moment, result.torque_amplitude
    return replace(
        result,
        mountings=[of_recording(each) for each in result.mountings],
        parameters=told(result.parameters),
        ratios=told(result.ratios),
        terms={term: told(own, f"{term}.") for term, own in result.terms.items()},
        gravity_moment=moment and change(moment, far.get("gravity_moment", 0.0)),
        torque_amplitude=torque and change(torque, far.get("torque_amplitude", 0.0)),
    )


def if_slack(each: Estimate, spread: float) -> Estimate:
    """With this error more, where it is to be noticed beside its own."""
    noticed = bool(each.standard_error) and spread > NOTICED * (each.standard_error or 0.0)
    return replace(each, if_slack=spread) if noticed else each
