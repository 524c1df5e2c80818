"""Where a drop came to rest, and when."""

from dataclasses import dataclass

import numpy as np

from exoid.recordings.landmarks.dying_swing import STANDING, middle_of
from exoid.recordings.landmarks.expected_rest import expected_rest
from exoid.recordings.landmarks.measure import NotAllowed
from exoid.recordings.landmarks.track import SURE, Peak, Track, nearest
from exoid.recordings.signal.condition import SMOOTHING
from exoid.recordings.signal.local_line import local_line

BAND = np.radians(2.0)  # rad to either side of the resting angle within which a leg is at rest
SHORTEST = 1.0  # s at rest by which a record must end, about one swing
SEEN = 5.0  # times the noise of the smoothed angle that the band is, or noise leaves it at rest
WIDEST = 0.3  # s of smoothing, a third of a swing
FADED = 4 * np.pi * np.sqrt(2)  # by which what a swing loses in a period shifts its mean over it


@dataclass(frozen=True)
class Rest:
    """The resting angle, read from the end of the record, and when the leg last came to it."""

    angle: Peak  # rad; its time is the middle of what was averaged
    since: Peak  # s; when the angle entered the band for good


class CutBefore(NotAllowed):
    """The record ends, or a hand takes the leg, while it still swings."""


def find_rest(track: Track, turns: list[Peak]) -> Rest:
    """The rest that a drop ends with.

    **Raises** `NotAllowed` where the record ends before, or a hand ended the swings.
    """
    lasting = max(SHORTEST, last_period(turns))
    first = int(np.searchsorted(track.time, track.time[-1] - lasting))
    width = window(track)
    smooth, slope = local_line(track.time, track.angle, width)
    swing = float(np.ptp(smooth[first:]))
    if track.time[first] - track.time[0] < lasting or swing > 2 * BAND:
        raise CutBefore(
            f"cut before rest: in the last {lasting:.2g} s the angle still moves by "
            f"{np.degrees(swing):.3g} deg, {np.degrees(2 * BAND):.0f} are the most. Record until "
            "the leg hangs still"
        )
    angle, error = resting_angle(track, smooth, first, turns, track.smoothed_noise(width))
    check_free([float(smooth[0]), *(each.value for each in turns)], angle, turns)
    lasted = track.time.size - first
    alike = track.rounded(np.full((1, lasted), 1 / lasted), slice(first, None))
    error = float(np.linalg.norm([error, stopped_short(angle, turns), *np.sqrt(alike[0])]))
    middle = float(track.time[first:].mean())
    resting = Peak(nearest(track, middle), middle, lasting / 2, angle, error)
    return Rest(resting, entered(track, resting, smooth, slope, track.smoothed_noise(width)))


def resting_angle(
    track: Track, smooth: np.ndarray, first: int, turns: list[Peak], noise: float
) -> tuple[float, float]:
    """Where a leg rests, by what it does since that sample, and the error of it [rad]: the middle
    of what is left of its swings, else the mean, which a swing that shrinks shifts.

    A leg that swings otherwise may have been stopped by friction: where it stands still within the
    `noise` of the smoothed angle at the end, that is its rest; else it is anywhere in its swing.
    """
    found = middle_of(track.time[first:], track.angle[first:], track.noise, turns)
    if found is not None:
        return found.value, found.error
    count = track.time.size - first
    stands = (part for part in STANDING if np.ptp(smooth[-int(part * count) :]) < 2 * SURE * noise)
    begin = track.time.size - int(next(stands, 1.0) * count)
    angle, swing = track.angle[begin:], float(np.ptp(smooth[begin:]))
    off = swing / 12**0.5 if len(turns) > 2 else swing / FADED
    return float(angle.mean()), float(np.hypot(track.noise / np.sqrt(angle.size), off))


def stopped_short(angle: float, turns: list[Peak]) -> float:
    """How far from the angle to which its swings shrink a leg stood still [rad], as one that a hand
    held softly does; 0 where friction may have left it there, or too few swings tell.
    """
    try:
        middle = expected_rest(turns)
    except NotAllowed:
        return 0.0
    off = abs(angle - middle.value)
    return off if off > SURE * middle.error else 0.0


def window(track: Track) -> float:
    """Over how much [s] the angle is smoothed, for noise not to leave the band of rest.

    **Raises** `NotAllowed` where that blurs the swings.
    """
    samples = (SEEN * track.noise / BAND) ** 2
    width = max(SMOOTHING, samples * track.step)
    if width > WIDEST:
        raise NotAllowed(
            f"too noisy: {np.degrees(track.noise):.2g} deg of noise hide whether a leg is within "
            f"{np.degrees(BAND):.0f} deg of its rest. Track at a higher rate, or the marker better"
        )
    return width


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
            f"not free until it rests: the swings end at once after {turns[-1].time:.2f} s, as by "
            "a hand, or by a muscle that tightens. Leave the leg alone, and relaxed, until it "
            "hangs still"
        )


def entered(
    track: Track, resting: Peak, smooth: np.ndarray, slope: np.ndarray, noise: float
) -> Peak:
    """When the angle, whose smoothed form has such a noise, came within the band of the resting
    angle and stayed there.

    A swing that just reaches out of the band, or just does not, makes half a period: the error
    holds it where a band that is surely wider or narrower gives another swing.
    """
    at, time = last_outside(track.time, smooth, resting.value, BAND)
    if at < 0:
        raise NotAllowed("at rest all the time")
    edge = resting.value + np.copysign(BAND, smooth[at] - resting.value)
    unsure = np.hypot(noise, resting.error)
    error = float(unsure) / max(abs(slope[at]), 1e-3)
    far = SURE * unsure
    others = (last_outside(track.time, smooth, resting.value, BAND + by) for by in (-far, far))
    swung = max(abs(other - time) for _, other in others)
    if swung > 2 * SURE * error:  # by a swing, not along the slope
        error = swung / 2
    return Peak(nearest(track, time), time, min(error, SHORTEST), float(edge), resting.error)


def last_outside(
    time: np.ndarray, smooth: np.ndarray, rest: float, band: float
) -> tuple[int, float]:
    """The last sample farther than `band` from rest, and when it comes within; -1 for none."""
    outside = np.flatnonzero(np.abs(smooth - rest) > band)
    if not outside.size:
        return -1, float(time[0])
    at = min(int(outside[-1]), time.size - 2)
    edge = rest + np.copysign(band, smooth[at] - rest)
    step = smooth[at + 1] - smooth[at]  # 0 where the record ends on one code outside
    share = float(np.clip((edge - smooth[at]) / step, 0.0, 1.0)) if step else 0.0
    return at, float(time[at] + share * (time[at + 1] - time[at]))
