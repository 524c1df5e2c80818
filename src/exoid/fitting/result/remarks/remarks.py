"""What the user should know of a fit, in sentences."""

import numpy as np

from exoid.fitting.data.conditioning_chain import SteadyKalman
from exoid.fitting.misfit.disturbance.torque_noise import torque_noise
from exoid.fitting.misfit.missed import Disturbance
from exoid.fitting.multistart.search_result import FEASIBLE, SearchResult, scale_told
from exoid.fitting.result.remarks.gyro_remarks import how_late, of_late_gyro, of_unused_gyro
from exoid.fitting.result.remarks.limit_remarks import of_bounds
from exoid.fitting.result.remarks.noise_remarks import noise_remarks
from exoid.fitting.result.remarks.residual_remarks import of_angle, of_kinds, of_residual
from exoid.fitting.result.remarks.stopped_remarks import of_kept, of_stopped
from exoid.fitting.result.remarks.upwards_remarks import of_impossible
from exoid.fitting.solve.problem import Problem
from exoid.physics.sensing.butterworth_filter import ButterworthFilter
from exoid.physics.sensing.first_order_filter import FirstOrderFilter
from exoid.physics.sensing.sensor_skew import SensorSkew
from exoid.physics.term import name_of

LATE = (SensorSkew, FirstOrderFilter, ButterworthFilter)  # terms of a sensor that comes late
ASK_DIAGNOSE = "; 'exoid diagnose' asks what the model lacks"


def as_taken(problem: Problem, found: Disturbance) -> list[str]:
    """How segments were taken, what of them counts, and what their sensors did beside measuring:
    nothing of that hangs on the numbers of the fit.
    """
    guessed = [each for each in problem.movements if not each.kind_said]
    said = [f"{each}." for each in of_stopped(problem.movements)]
    if guessed:
        each = ", ".join(f"{one.name} {one.kind}" for one in guessed)
        said.append(f"the sidecar does not say how the leg was moved; by its motion: {each}.")
    return [
        *said,
        *of_filter(problem),
        *of_unused_gyro(problem.movements),
        *of_memory(problem),
        *of_late(problem, found),
        *of_kept(problem.movements),
        *noise_remarks(problem.movements),
    ]


def remarks(
    problem: Problem,
    ended: SearchResult,
    at_bound: set[str],
    inertia: float | None,
    *,
    swung: bool = False,
) -> list[str]:
    """How segments were taken, what the residual holds, and which limits decided. `inertia` is J as
    it is told, if it is. Of a leg that a tone has `swung` the residual is no noise.
    """
    said, rig = of_impossible(problem, ended), problem.belief.rig
    said += as_taken(problem, ended.disturbance)
    gravity = float(ended.best.coordinates.shared.gravity[0])
    if not scale_told(ended.local.data + ended.local.prior):
        inertia = None
    said += of_kinds(ended.disturbance)
    unit = np.mean([each.residual_unit / each.angle_noise for each in problem.movements])
    within = float(ended.best.misfit[0]) * unit**2 < problem.samples.sum()
    cause = ended.disturbance.cause
    late = [] if cause is None or models_lateness(problem) else of_late_gyro(problem.movements)
    quiet = swung and cause is None
    of_sensors = cause == "encoder" and (within or late)  # smoothed errors, which are told
    if not of_sensors and not quiet:
        torque = torque_noise(problem.movements)
        said += of_residual(ended.disturbance, gravity, inertia, float(unit), torque)
    said += late
    if of_sensors and late and ended.by_angle is not None:
        said += of_angle(ended.by_angle, gravity, inertia)
    if rig and "stiffness" not in problem.absent:
        said.append(
            "on a rig the spring term c phi also takes up a constant torque and an encoder zero "
            "that is off: read c / J as a spring only where a spring is known to be. Where none "
            'is, [subject] spring = "none" leaves it out. One that hangs from above or below the '
            "axis pulls with the cosine of the angle, as gravity does: m l g holds that pull, too, "
            "and no motion parts them."
        )
    if float(ended.best.violation[0]) > FEASIBLE:
        said.append("the limits could not all be met: see the bounds in the table.")
    said += of_bounds(problem, at_bound)
    if sum(each.voluntary for each in problem.movements) > 1:
        said.append(
            "tau and tau / J are means over the voluntary segments, each with its own effort."
        )
    return said


def of_filter(problem: Problem) -> list[str]:
    """A filter that the simulation passes, though nobody said that it was that one."""
    untold = [each.name for each in problem.movements if not each.filter_told]
    if not (untold and isinstance(problem.chain, SteadyKalman)):
        return []
    return [
        f"segment {', '.join(untold)}: which filter angle and velocity went through is not told. "
        f"The simulation passes the node's of {problem.chain.design}; [sensors] filter says "
        "another."
    ]


def of_memory(problem: Problem) -> list[str]:
    """What the errors leave out where a term remembers what nobody recorded."""
    moving = [each.name for each in problem.movements if each.extent and each.extent.in_motion]
    said = []
    for term in problem.terms:
        if term.memory_size and moving:
            said.append(
                f"segment {', '.join(moving)} begins in motion: what {name_of(term)} remembers of "
                "before is unknown, and taken as of a leg let go just then. Its numbers, d / J and "
                "c / J may be wrong by more than their errors say. Record from a hold on."
            )
        elif term.lasting:
            said.append(
                f"{name_of(term)} may remember for seconds how the leg was moved before it was "
                "held, and is taken to be at rest there: a short hold makes its numbers, d / J and "
                "c / J wrong by more than their errors say. Hold the leg longer."
            )
    return said


def of_late(problem: Problem, found: Disturbance) -> list[str]:
    """Which movements begin to count late, though nobody was seen to hold the leg. What the model
    misses all the time is likelier there than a slow hand.
    """
    late = [each for each in problem.movements if each.late]
    if not late:
        return []
    longest = max(float(each.segment.time[each.late]) for each in late)
    hand = ", as where a hand lets go slowly" if found.cause is None else ""
    return [
        f"the first {longest:.2f} s of segment {', '.join(each.name for each in late)} weigh "
        "nothing: the recording begins as the leg is let go, and they do not fit to the "
        f"rest{hand}. Record from 0.3 s before the release on."
    ]


def of_astray(why: str, problem: Problem) -> list[str]:
    """That the simulation does not follow the recording, and what to do."""
    belief, several = problem.belief, len(problem.recordings) > 1
    late = None if models_lateness(problem) else how_late(problem.movements)
    first = f"{late}; else " if late else ""
    masses = ", and what mass was on the leg in each" if several else ""
    named = ", ".join(belief.by_hand.names)
    yours = f", and what you said of {named}" if named else ""
    weighed = "; without --misfit paper every sample is weighed by its noise" if belief.raw else ""
    return [
        f"the simulation does not follow the recording: {why}. Do not use its numbers: {first}"
        f"check units, signs, zero and marks of the recording{masses}{yours}{ASK_DIAGNOSE}"
        f"{weighed}."
    ]


def models_lateness(problem: Problem) -> bool:
    """Has the model a term for a sensor that comes late?"""
    return any(each in LATE for each in problem.terms)
