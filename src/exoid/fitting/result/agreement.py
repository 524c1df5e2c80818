"""Does a simulation follow the recording that it was fitted to?"""

from collections.abc import Sequence

import numpy as np

from exoid.fitting.misfit.missed import Disturbance
from exoid.fitting.result.segment_fit import SegmentFit, pooled
from exoid.fitting.solve.problem import Problem

ASTRAY = 0.1  # of how far the leg moves, missed beyond the noise: then it is another motion
ALONE = 0.3  # the same of a single segment: a small one may hold what the model misses
HELD = 0.03  # the same where a limit decided ...
HELD_NOISE = 10.0  # ... and times the noise
RUNAWAY = 2.0  # times how far the leg moves: one of its size misses that at most, in antiphase
EXPLAINED = 3.0  # times the noise, up to which segments are said to be explained
UNLIKE = 3.0  # times what a kind of segments leaves alone: then one leg does not explain both


def astray(segments: Sequence[SegmentFit], limits: Sequence[str] = ()) -> str | None:
    """Why a fit does not follow its recording; None where it does.

    What is missed (root mean square of the angle, the noise taken off) is compared with how far the
    leg moves (standard deviation). `limits` are those that the fit lies on: what it misses there is
    not the physics that a diagnosis looks for.
    """
    missed, moved = pooled(segments, beyond_noise), pooled(segments, motion)
    noise = pooled(segments, lambda each: each.angle_noise)
    if missed >= ASTRAY * moved:
        return told(missed, moved)
    if limits and missed >= max(HELD * moved, HELD_NOISE * noise):
        return f"{told(missed, moved)}: held by {', '.join(limits)}"
    worst = max(segments, key=lambda each: beyond_noise(each) / motion(each))
    if beyond_noise(worst) >= ALONE * motion(worst):
        return f"in segment {worst.name} {told(beyond_noise(worst), motion(worst))}"
    return None


def believed(segments: Sequence[SegmentFit], found: Disturbance) -> list[SegmentFit]:
    """The segments of the kinds that were weighed as they are: the others told hardly anything."""
    return [each for each in segments if not found.apart or found.scales[each.kind] == 1.0]


def of_the_rest(segments: list[SegmentFit], found: Disturbance) -> list[str]:
    """That the simulation does not follow segments that were not believed."""
    others = unbelieved(segments, found)
    why = astray(others) if others else None
    if why is None:
        return []
    kept = believed(segments, found)
    missed, noise = (pooled(kept, of) for of in (lambda one: one.angle_rmse, noise_of))
    if missed < EXPLAINED * noise:
        because = "the others are explained"
    else:
        because = (
            f"the others are missed by less, {np.degrees(missed):.2g} deg, which is still "
            f"{missed / noise:.0f} times the noise: something is missing in these, too"
        )
    return [
        f"{not_followed(others)}: {why}. They told hardly anything, because {because}. No number "
        "is given that they alone tell."
    ]


def of_unlike(segments: Sequence[SegmentFit], found: Disturbance) -> list[str]:
    """Kinds of segments that a leg of their own explains, and that of the others does not."""
    said = []
    for kind, alone in found.alone.items():
        own = [each for each in segments if each.kind == kind]
        beside = pooled(own, over_noise)
        if found.scales[kind] > 1.0 and beside > UNLIKE * max(alone, 1.0):
            missed = np.degrees(pooled(own, lambda each: each.angle_rmse))
            said.append(
                f"one leg does not explain all kinds of segments: the {kind} ones are missed by "
                f"{missed:.2g} deg, {beside:.0f} times the noise, and by themselves would be by "
                f"{alone:.2g} times. What is said of their residual is said of them alone, and ± "
                "does not hold what differs between the kinds: the seat, a hand, friction, or the "
                "zero and gain of a measured torque."
            )
    return said


def over_noise(each: SegmentFit) -> float:
    """Root mean square of what is missed of angle and gyro, over their noise."""
    angle = each.angle_rmse / each.angle_noise
    if each.velocity_rmse is None or not each.velocity_noise:
        return angle
    return float(np.sqrt((angle**2 + (each.velocity_rmse / each.velocity_noise) ** 2) / 2))


def noise_of(each: SegmentFit) -> float:
    """Of its angle [rad]."""
    return each.angle_noise


def unbelieved(segments: Sequence[SegmentFit], found: Disturbance) -> list[SegmentFit]:
    """The segments of the other kinds."""
    kept = {each.kind for each in believed(segments, found)}
    return [each for each in segments if each.kind not in kept]


def not_followed(segments: Sequence[SegmentFit]) -> str:
    """That the simulation does not follow these."""
    kinds = " and ".join(sorted({each.kind for each in segments}))
    return f"the simulation does not follow the {kinds} segments"


def lost(segments: Sequence[SegmentFit], found: Disturbance) -> str | None:
    """Why what only segments that were not believed tell is worth nothing; None where it is."""
    others = unbelieved(segments, found)
    return f"{not_followed(others)}, which alone tell it" if others and astray(others) else None


def roughly(error: float, segments: Sequence[SegmentFit]) -> bool:
    """Does a model that misses the angle by `error` [rad] follow these segments?"""
    return error < ASTRAY * pooled(segments, motion)


def elsewhere(segments: Sequence[SegmentFit]) -> bool:
    """Is the simulation another motion altogether, as in a false valley?"""
    return pooled(segments, beyond_noise) >= ALONE * pooled(segments, motion)


def told(missed: float, moved: float) -> str:
    if missed >= RUNAWAY * moved:
        return (
            f"it runs away from it, farther than the leg moves ({np.degrees(moved):.3g} deg, root "
            "mean square): with none of the parameters that were tried it stays near"
        )
    return (
        f"it misses the angle by {np.degrees(missed):.3g} deg, where the leg moves by "
        f"{np.degrees(moved):.3g} deg (both root mean square)"
    )


def beyond_noise(each: SegmentFit) -> float:
    """What is missed and is not noise [rad]."""
    return float(np.sqrt(max(each.angle_rmse**2 - each.angle_noise**2, 0.0)))


def motion(each: SegmentFit) -> float:
    """How far the leg moves about its mean [rad]."""
    return float(max(np.nanstd(each.angle), 1e-9))


def simulated(problem: Problem, table: np.ndarray, number: int) -> np.ndarray:
    """What a `table` (start, segment, step) has of the first start at the samples of a segment; nan
    after the last that counts in any, where the simulation ends.
    """
    rows = problem.own_rows(number)
    return np.where(rows <= problem.steps, table[0, number][rows], np.nan)


def root_mean_square(samples: np.ndarray) -> float:
    return float(np.sqrt(np.nanmean(samples**2)))
