"""What the user should know of a fit, in sentences."""

import numpy as np

from exoid.fitting.data.conditioning_chain import SteadyKalman
from exoid.fitting.data.movement import all_driven
from exoid.fitting.misfit.disturbance.explain import CORRELATED
from exoid.fitting.misfit.missed import NOISY, Disturbance, Missed
from exoid.fitting.model.belief import Belief
from exoid.fitting.multistart.search_result import FEASIBLE, SearchResult, scale_told
from exoid.fitting.result.remarks.gyro_remarks import (
    how_late,
    of_late_gyro,
    of_unused_gyro,
)
from exoid.fitting.result.remarks.noise_remarks import noise_remarks
from exoid.fitting.result.remarks.stopped_remarks import of_stopped
from exoid.fitting.solve.problem import Problem
from exoid.physics.leg import LegParameters
from exoid.physics.parameter import declarations
from exoid.physics.sensing.butterworth_filter import ButterworthFilter
from exoid.physics.sensing.first_order_filter import FirstOrderFilter
from exoid.physics.sensing.sensor_skew import SensorSkew
from exoid.physics.term import name_of
from exoid.recordings.conventions.angle_convention import ON_ITS_SIDE

UPWARDS = (
    "gravity comes out upwards (m l g / J is negative): no leg falls like this. The angle must be "
    "0 with the knee extended and the shank level, -90 deg hanging, extension positive. Is flexion "
    'positive in this file? Then say flip="angle" (flip="all" with a gyro of the same sign). Is 0 '
    'the hanging leg? Then say zero="hanging".'
)
NO_RIG = (
    "gravity would pull upwards: of this rig a spring and gravity are not told apart. Where no "
    'spring is, say [subject] spring = "none"'
)
REACH = "J <= reach m l"
RULES = {
    "m l^2 <= J": "that J of a rigid leg is at least m l^2",
    REACH: "that J / (m l) of a leg is no longer than the leg from knee to toe",
}
LATE = (SensorSkew, FirstOrderFilter, ButterworthFilter)  # terms of a sensor that comes late
SLIGHT = 1e-3  # of m l g, below which an unknown torque changes no number that anybody reads
ASK_DIAGNOSE = "; 'exoid diagnose' asks what the model lacks"
INCOMPLETE = "no error bar of a model that misses something is complete"


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
        *of_kept(problem),
        *noise_remarks(problem.movements),
    ]


def remarks(
    problem: Problem, ended: SearchResult, at_bound: set[str], *, swung: bool = False
) -> list[str]:
    """How segments were taken, what the residual holds, and which limits decided. Of a leg that a
    tone has `swung` the residual is no noise.
    """
    said, rig = of_impossible(problem, ended), problem.belief.rig
    said += as_taken(problem, ended.disturbance)
    gravity = float(ended.best.coordinates.shared.gravity[0])
    told = scale_told(ended.local.data + ended.local.prior)
    inertia = float(ended.best.leg.inertia[0]) if told else None
    said += of_kinds(ended.disturbance)
    unit = np.mean([each.residual_unit / each.angle_noise for each in problem.movements])
    within = float(ended.best.misfit[0]) * unit**2 < problem.samples.sum()
    sensors = ended.disturbance.cause == "encoder"
    asked = sensors and not models_lateness(problem)
    late = of_late_gyro(problem.movements) if asked else []
    quiet = swung and ended.disturbance.cause is None
    if not late and not quiet and not (within and sensors):  # smoothed errors, which are told
        said += of_residual(ended.disturbance, gravity, inertia, float(unit))
    said += late
    if rig and "stiffness" not in problem.absent:
        said.append(
            "on a rig the spring term c phi also takes up a constant torque and an encoder zero "
            "that is off: read c / J as a spring only where a spring is known to be. Where none "
            'is, [subject] spring = "none" leaves it out.'
        )
    if float(ended.best.violation[0]) > FEASIBLE:
        said.append("the limits could not all be met: see the bounds in the table.")
    said += of_bounds(problem, at_bound)
    if sum(each.voluntary for each in problem.movements) > 1:
        said.append(
            "tau and tau / J are means over the voluntary segments, each with its own effort."
        )
    return said


def of_impossible(problem: Problem, ended: SearchResult) -> list[str]:
    """That no rig falls like this."""
    return [f"m l g / J and c / J: {NO_RIG}."] if upside_down(problem, ended) else []


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


def of_kept(problem: Problem) -> list[str]:
    """Which movements count only up to where a hand seems to keep the leg."""
    return [
        f"segment {each.name} counts only up to {each.segment.time[each.kept]:.2f} s after its "
        "release: then it leaves the motion that all drops tell, as where a hand stops the leg and "
        "keeps it. Leave it alone until it hangs still."
        for each in problem.movements
        if each.kept is not None
    ]


def upwards(problem: Problem, ended: SearchResult) -> bool:
    """Does gravity come out upwards, of a leg that nothing but gravity moved?"""
    return (
        float(ended.best.coordinates.shared.gravity[0]) < 0
        and not problem.belief.rig
        and all(each.kind == "passive" for each in problem.movements)
    )


def upside_down(problem: Problem, ended: SearchResult) -> bool:
    """Does gravity come out upwards, of a rig that was not driven all the time?"""
    gravity = float(ended.best.coordinates.shared.gravity[0])
    return problem.belief.rig and not all_driven(problem.movements) and gravity < 0


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


def of_kinds(found: Disturbance) -> list[str]:
    """Which kind of segment is believed, where kinds are weighed differently."""
    if not found.apart:
        return []
    trusted = [kind for kind, scale in found.scales.items() if scale == 1.0]
    others = [
        f"those of the {kind} ones are divided by {scale:.2g}"
        for kind, scale in found.scales.items()
        if kind not in trusted
    ]
    return [
        "what the model misses differs from kind to kind of segment, and each is weighed by its "
        f"own: the residuals of the {' and '.join(trusted)} segments count as they are, "
        f"{', '.join(others)}. 'set by' names the kind that told a number."
    ]


def of_residual(
    found: Disturbance, gravity: float, inertia: float | None, unit: float
) -> list[str]:
    """What besides the declared noise is in the residuals, and what that does to the errors.

    `gravity` is m l g / J [1/s^2]; `inertia` None where J is not known; `unit` that of the
    residuals over the noise.
    """
    noisy = of_noisy_torque(found, gravity)
    if len(set(found.kinds.values())) == 1:
        missed = next(iter(found.kinds.values()))
        return of_missed(missed, "the residual", gravity, inertia, unit) + noisy
    return [
        sentence
        for kind, each in found.kinds.items()
        for sentence in of_missed(each, f"the residual of {kind} segments", gravity, inertia, unit)
    ] + noisy


def of_noisy_torque(found: Disturbance, gravity: float) -> list[str]:
    """What it means where the noise of a measured torque would look alike: a simulation that such
    noise drives strays less the heavier its leg is.
    """
    missed = found.kinds.get("measured")
    if missed is None or missed.cause != "torque" or slight(missed, gravity):
        return []
    if missed.correlation_time > CORRELATED[0]:
        return []
    return [
        "noise of the measured torque looks like that, too. It makes J too large and the ratios to "
        "it too small, by more than ± says where the leg is led slowly and evenly, as by a stiff "
        "motor: move it quicker and less evenly, or measure the torque with less noise."
    ]


def slight(found: Missed, gravity: float) -> bool:
    """Is what is missed a torque that matters to nobody, beside m l g over J [1/s^2]?"""
    return found.cause == "torque" and found.deviation < SLIGHT * abs(gravity)


def of_missed(
    found: Missed, where: str, gravity: float, inertia: float | None, unit: float
) -> list[str]:
    """The same of one kind of segment, or of all."""
    over = f"varying within about {found.correlation_time:g} s"
    if found.correlation_time == CORRELATED[0]:
        over = "varying from moment to moment"
    widened = f"Errors are widened for it; {INCOMPLETE}, and 'exoid diagnose' asks what it misses."
    if found.cause == "torque":
        each = [f"{100 * found.deviation / abs(gravity):.2g} % of m l g"] if gravity else []
        each += [] if inertia is None else [f"{found.deviation * inertia:.2g} N m"]
        share = ", ".join(each) or f"{found.deviation:.2g} rad/s^2 times J"
        if slight(found, gravity):
            return [
                f"{where} holds a little more than the sensors' noise, as an unknown torque of "
                f"about {share}, {over}, would leave it. Errors are widened for it."
            ]
        return [
            f"{where} is more than the sensors' noise: the model misses something. It is what "
            f"an unknown torque of about {share}, {over}, would leave. {widened}"
        ]
    if found.cause == "encoder":
        return [
            f"{where} is more than the sensors' noise: it is what an encoder that errs by "
            f"about {np.degrees(found.deviation):.2g} deg, {over}, or a thigh or base that turns "
            f"under it, would leave. {widened}"
        ]
    if found.noise > max(NOISY / unit, 1.0):  # 1 where it is not larger, or is less
        return [
            f"{where} is white but {found.noise * unit:.3g} times the noise that is declared, or "
            "that neighbouring samples show, and standard errors are widened by that: check noise "
            "levels and time stamps."
        ]
    return []


def of_bounds(problem: Problem, at_bound: set[str]) -> list[str]:
    """Which limits decided, and what to do."""
    said, belief = [], problem.belief
    limits = belief.limits
    for name, declared in declarations(LegParameters):
        if name in at_bound and not belief.rig:
            low, high = (float(getattr(each, name)) for each in (limits.lower, limits.upper))
            said.append(
                f"{declared.symbol} ran into its limits of {low:.3g} to {high:.3g} {declared.unit} "
                f"({whose(belief, name)}). Absolute values that go with it follow from that limit, "
                "not from the recording: use the ratios."
            )
    for rule in RULES:
        if rule in at_bound:
            weak = f" Gravity turns no leg that hangs so little. {ON_ITS_SIDE}" * (rule == REACH)
            said.append(f"the fit lies on the limit {RULES[rule]} ({rule}).{weak}")
    return said


def limits_met(problem: Problem, at_bound: set[str]) -> list[str]:
    """The limits of a leg that decided, by their symbols; that damping is not negative is none."""
    if problem.belief.rig:
        return []
    held = [
        declared.symbol
        for name, declared in declarations(LegParameters)
        if name in at_bound and name != "damping"
    ]
    return [*held, *(f"the limit {words}" for rule, words in RULES.items() if rule in at_bound)]


def whose(belief: Belief, name: str) -> str:
    """Where a limit comes from."""
    if name in belief.by_hand.bound:
        return "yours"
    if belief.bounds == "paper":
        return "Eq. 13"
    unknown = belief.expected is None or belief.untabled
    return "any human's" if unknown else "what a leg of this body can have"
