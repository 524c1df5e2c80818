"""Where a drop came to rest, and when."""

from dataclasses import dataclass

import numpy as np

from exoid.recording.condition import SMOOTHING, local_line
from exoid.recording.pendulum.measure import NotAllowed
from exoid.recording.pendulum.track import Peak, Track, nearest

BAND = np.radians(2.0)  # rad to either side of the resting angle within which a leg is at rest
SHORTEST = 1.0  # s at rest by which a record must end, about one swing
FADED = 4 * np.pi * np.sqrt(2)  # by which what a swing loses in a period shifts its mean over it


@dataclass(frozen=True)
class Rest:
    """The resting angle, read from the end of the record, and when the leg last came to it."""

    angle: Peak  # rad; its time is the middle of what was averaged
    since: Peak  # s; when the angle entered the band for good


def find_rest(track: Track, turns: list[Peak]) -> Rest:
    """The rest that a drop ends with.

    **Raises** `NotAllowed` where the record ends before, or a hand ended the swings.
    """
    lasting = max(SHORTEST, last_period(turns))
    first = int(np.searchsorted(track.time, track.time[-1] - lasting))
    smooth, slope = local_line(track.time, track.angle, SMOOTHING)
    swing = float(np.ptp(smooth[first:]))
    if track.time[first] - track.time[0] < lasting or swing > 2 * BAND:
        raise NotAllowed(
            f"cut before rest: in the last {lasting:.2g} s the angle still moves by "
            f"{np.degrees(swing):.3g} deg, {np.degrees(2 * BAND):.0f} are the most. Record until "
            "the leg hangs still"
        )
    angle = float(track.angle[first:].mean())
    error = float(
        np.hypot(track.noise / np.sqrt(track.time.size - first), swing * loss(turns) / FADED)
    )
    check_free([float(smooth[0]), *(each.value for each in turns)], angle, turns)
    middle = float(track.time[first:].mean())
    resting = Peak(nearest(track, middle), middle, lasting / 2, angle, error)
    return Rest(resting, entered(track, resting, smooth, slope))


def loss(turns: list[Peak]) -> float:
    """The share of its amplitude that the last swing loses in a period; all of it, if unknown."""
    if len(turns) < 3:
        return 1.0
    before, last, end = (each.value for each in turns[-3:])
    return 1 - min(abs(end - last) / abs(last - before), 1.0) ** 2


def last_period(turns: list[Peak]) -> float:
    """Of the last full swing [s]; 0 where there is none."""
    return turns[-1].time - turns[-3].time if len(turns) > 2 else 0.0


def check_free(ends: list[float], angle: float, turns: list[Peak]) -> None:
    """Refuse a rest that comes while the leg should still swing past it, or far from its middle.

    `ends` are the start and the turns [rad]. Swings of a free leg shrink by a factor (viscous
    damping) or by equal steps (friction). So the next one is at least as long as the last less what
    the last had lost, and their middle is no farther from rest than that loss. Of a single swing
    only its two sides are known: it goes no farther past the rest than it came from. A leg that
    sinks below its swings is not judged.
    """
    if len(ends) < 2:
        return
    last, end = ends[-2:]
    swing, beyond = abs(end - last), abs(end - angle)
    if len(ends) > 3:
        lost = max(abs(last - ends[-3]) - swing, 0.0)
        past = swing - lost - beyond > 2 * BAND
        aside = abs(angle - (last + end) / 2) > lost + BAND
    else:
        past, aside = 2 * beyond - abs(last - angle) > 2 * BAND, False
    if min(last, end) < angle < max(last, end) and (past or aside):
        raise NotAllowed(
            f"caught: the swings end at once after {turns[-1].time:.2f} s, as by a hand. Leave the "
            "leg alone until it hangs still"
        )


def entered(track: Track, resting: Peak, smooth: np.ndarray, slope: np.ndarray) -> Peak:
    """When the angle came within the band of the resting angle and stayed there.

    A swing that just reaches out of the band, or just does not, makes half a period: the error
    holds how far the time goes with a band that is wider or narrower by an error of the angle.
    """
    at, time = last_outside(track.time, smooth, resting.value, BAND)
    if at < 0:
        raise NotAllowed("at rest all the time")
    edge = resting.value + np.copysign(BAND, smooth[at] - resting.value)
    error = np.hypot(track.noise, resting.error) / max(abs(slope[at]), 1e-3)
    samples = max(SMOOTHING / float(np.median(np.diff(track.time))), 1.0)
    unsure = np.hypot(track.noise / np.sqrt(samples), resting.error)
    others = (
        last_outside(track.time, smooth, resting.value, BAND + by) for by in (-unsure, unsure)
    )
    swung = max(abs(other - time) for _, other in others) / 2
    error = min(max(error, swung), SHORTEST)
    return Peak(nearest(track, time), time, float(error), float(edge), resting.error)


def last_outside(
    time: np.ndarray, smooth: np.ndarray, rest: float, band: float
) -> tuple[int, float]:
    """The last sample farther than `band` from rest, and when it comes within; -1 for none."""
    outside = np.flatnonzero(np.abs(smooth - rest) > band)
    if not outside.size:
        return -1, float(time[0])
    at = min(int(outside[-1]), time.size - 2)
    edge = rest + np.copysign(band, smooth[at] - rest)
    share = float(np.clip((edge - smooth[at]) / (smooth[at + 1] - smooth[at]), 0.0, 1.0))
    return at, float(time[at] + share * (time[at + 1] - time[at]))
