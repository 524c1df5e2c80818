"""Does a simulation follow the recording that it was fitted to?"""

from collections.abc import Sequence

import numpy as np

from exoid.fitting.misfit.missed import Disturbance
from exoid.fitting.result.fit_result import SegmentFit, pooled

ASTRAY = 0.1  # of how far the leg moves, missed beyond the noise: then it is another motion
ALONE = 0.3  # the same of a single segment: a small one may hold what the model misses
HELD = 0.03  # the same where a limit decided ...
HELD_NOISE = 10.0  # ... and times the noise


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
    return [
        f"{not_followed(others)}: {why}. They told hardly anything, because the others are "
        "explained: no number is given that they alone tell."
    ]


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
