"""When the right answer is that this recording cannot tell."""

import numpy as np

from exoid.fitting.model.belief import Belief
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.remarks.anatomy_remarks import at_rate, from_anatomy, unlike_anatomy
from exoid.fitting.result.remarks.stopped_remarks import of_stopped
from exoid.mismatch.conclude.false_alarm import FAR, Chance
from exoid.mismatch.evidence.prediction import Proof
from exoid.mismatch.novel.formula import Formula
from exoid.mismatch.screen.hypothesis import Optimum
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.physics.anatomy.expected import STRANGE
from exoid.physics.term import SensorTerm
from exoid.recordings.conventions.jumps import jumping
from exoid.recordings.signal.noise import of_hidden_noise

SHORTEST = 1.5  # s of movement in all, about one swing of a leg
QUIETEST = np.radians(12.0)  # rad, of movement: less is within straps and skin
CYCLES = 3  # that a claim about the leg needs where all are voluntary
MOSTLY, NEARLY_ALL = 0.5, 0.8  # of resampled segments: must name the same cause; the same set
HALF = 0.5  # of the variance of what is missing, that a formula must explain
FAINT = 3.0  # mean square over the noise, below which several causes at once are no claim
FARTHER = 1.0  # standard deviations of legs, by which a cause drives one from what anatomy expects
APART = 0.05  # relative, by which the slowest must be slower than the fastest


def too_little(prepared: PreparedRecording) -> list[str]:
    """Why hardly anything could be seen in this recording, in sentences; none where it could."""
    reasons = []
    movements = prepared.problem.movements
    duration = sum(each.segment.time[-1] for each in movements)
    if duration < SHORTEST:
        reasons += of_stopped(movements) or [
            f"{duration:.1f} s of movement are too short: record drops until the leg rests"
        ]
    low, high = prepared.range
    if high - low < QUIETEST * min(prepared.scale.angle, 1.0):
        reasons.append(
            f"the leg moves by {np.degrees(high - low):.0f} deg only: release it from higher up"
        )
    return reasons


def broken(prepared: PreparedRecording) -> list[str]:
    """That the angle jumps: behind that it has another zero, or its times are wrong."""
    said = jumping({each.name: each.jumps for each in prepared.problem.movements})
    return [said] if said else []


def unremembered(prepared: PreparedRecording) -> list[str]:
    """That a leg which begins in motion may remember what nobody recorded."""
    begun = [one.name for one in prepared.problem.movements if one.extent and one.extent.in_motion]
    if prepared.rig or not begun:
        return []
    return [
        f"no cause explains it down to the noise, and segment {', '.join(begun)} begins in motion: "
        "what tissue and reflexes still do of the time before is unknown. Record from a hold on"
    ]


def unrelaxed(prepared: PreparedRecording, best: Optimum) -> list[str]:
    """That what fits best may remember how the leg came to where it was held."""
    remembering = [term.title for term in best.candidate.terms if term.lasting]
    if prepared.rig or not remembering:
        return []
    return [
        f"{' and '.join(remembering)} fits best, but not down to the noise: how the leg was moved "
        "before it was held is unknown. Hold it still for 10 s before each release"
    ]


def faint(square: float, causes: int) -> list[str]:
    """That a mismatch about as large as the noise itself takes several causes at once.

    `square` is the mean square of what is missing and of the noise, over the noise.
    """
    if causes < 2 or square > FAINT:
        return []
    return [
        f"simulation and recording differ by {square**0.5:.2g} times the noise only, and it would "
        f"take {causes} causes at once: move it further, or measure with less noise"
    ]


def unlike_a_leg(belief: Belief, before: Estimate, after: Estimate) -> list[str]:
    """That what would be missing leaves a leg that nobody has, and less of one than Eq. 9 alone.

    Springs and gravity make up for each other: what is not the physics that it is called drives
    m l g / J away, from `before` to `after`, and by more than it may by chance.
    """
    if before.value is None or after.value is None:
        return []
    error = after.standard_error or 0.0
    known, now = (abs(from_anatomy(belief, one, error)) for one in (before.value, after.value))
    if now < known + FARTHER:
        return []
    odd = known >= STRANGE
    rate = f", and {at_rate(belief, before.value)} would make it ordinary" if odd else ""
    return [
        f"what explains it best leaves a leg that is no leg: {each}. Without it, it is nearer{rate}"
        for each in unlike_anatomy(belief, after.value, error)
    ]


def vague(formula: Formula | None, guess: float | None = None) -> list[str]:
    """That a formula explains too little of what is missing to be called what the library lacks;
    over J where that is a `guess` [kg m^2].
    """
    if formula is None or formula.explained >= HALF:
        return []
    words = formula.words if guess is None else formula.over(guess)
    return [
        f"no cause explains it, and the formula that comes nearest, {words}, only "
        f"{formula.explained:.0%} of the variance of what is missing"
    ]


def filtered_away(prepared: PreparedRecording, formula: Formula | None) -> list[str]:
    """That an angle went through a filter, which makes of a release what looks like a torque."""
    hidden = [one.noise for one in prepared.problem.movements if one.noise.hidden]
    if formula is None or prepared.rig or not hidden:
        return []
    return [of_hidden_noise(hidden[0])]


def luck(lucky: Chance) -> list[str]:
    """That what is left would often enough look like a cause by chance, and how much less."""
    if not lucky.doubtful:
        return []
    return [
        "of recordings that leave as much unexplained as this one, chance makes some cause clear "
        f"in one of twenty, and what was found is only {lucky.claimed / lucky.usual:.2g} times as "
        f"clear ({FAR:.0f} would do): record the same movement again, for what is of the leg "
        "comes back"
    ]


def chance(repeated: float | None, causes: int) -> list[str]:
    """That other segments of the same leg would have given another answer. Of several causes at
    once there are thousands of sets, and one stands in for another.
    """
    if repeated is None or repeated >= (NEARLY_ALL if causes > 1 else MOSTLY):
        return []
    return [
        f"only {repeated:.0%} of resampled segments give the same answer: record more releases, "
        "from other angles"
    ]


def unsure(
    prepared: PreparedRecording, best: Optimum, proof: Proof, *, explained: bool
) -> list[str]:
    """Why what was found must not be claimed."""
    reasons = [] if explained else unremembered(prepared)
    sensors_only = all(issubclass(term, SensorTerm) for term in best.candidate.terms)
    if not proof.holds:
        where = "held-out quarters" if proof.in_time else "held-out segments"
        reasons.append(f"it does not predict {where} better than the model without it")
    movements = prepared.problem.movements
    if all(each.voluntary for each in movements) and not sensors_only:
        periods = [each.period for each in movements]
        if len(periods) < CYCLES or max(periods) < (1 + APART) * min(periods):
            reasons.append(
                f"{len(periods)} voluntary cycles of one speed cannot tell the leg from the "
                "muscles: add passive drops, or cycles of three speeds"
            )
    return reasons
