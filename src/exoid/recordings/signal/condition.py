"""Conditioning of what was measured: the moving average (Eq. 3), clipping, and the frequency of the
driving torque (Eq. 4).
"""

import numpy as np
from numpy.typing import NDArray

from exoid.recordings.declared.protocol import Kind
from exoid.recordings.measured.samples import Samples
from exoid.recordings.measured.segment import Segment
from exoid.recordings.signal.local_line import Signal, interpolated, local_line
from exoid.recordings.signal.spikes import ANGLES, spikes_of
from exoid.recordings.signal.turns import bends

MOTION_SPEED = np.radians(20.0)  # rad/s, the paper's criterion of significant motion
SMOOTHING = 0.05  # s, of the velocity that decides what moves; half a leg's swing takes 0.5 s
FREE, SHRUNK = 3, 0.8  # swings that no muscle makes, and to what share they shrink in all
BRIDGED = 0.1  # s without a sample: a line over it takes 1 in 25 off a swing that turns there
LESS = 0.97  # of the swing before, beside a hole: a muscle's cycles, back at one angle, shrink less
STILL = np.radians(1.0)  # rad: what goes no farther may be noise alone
RINGING = 0.1  # of its travel: the least that a swing goes
ENDS = 3  # samples, of which one may be wild
NEAR = 0.35  # of the range of a movement; a drop ends at 0.5 (no damping) to 1 of it, lower


def moving_average(samples: Signal, window: int) -> Signal:
    """T(i) = 1/h (phi(i) + ... + phi(i + h - 1)), Eq. 3 with h = `window`, full windows only.

    The result has `window - 1` samples fewer. It is linear, takes NumPy and JAX arrays, and a
    missing sample spoils the windows that hold it.
    """
    count = samples.shape[0] - window + 1
    if window < 1 or count < 1:
        raise ValueError(
            f"a moving average over {window} samples does not fit a record of {samples.shape[0]}; "
            f"choose a window between 1 and {samples.shape[0]}."
        )
    return sum(samples[lag : lag + count] for lag in range(window)) / window


def clip(angular_velocity: Samples, threshold: float = MOTION_SPEED) -> slice:
    """From the first to the last sample that moves faster than `threshold` [rad/s] either way.

    Only the ends are cut: slow samples between, such as the turn at the bottom, stay.
    """
    fast = np.flatnonzero(np.abs(angular_velocity) > threshold)  # NaN compares false
    if fast.size == 0:
        raise ValueError(
            f"no sample moves faster than {np.degrees(threshold):g} deg/s: there is no movement "
            "to keep. Is the velocity in rad/s? If so, release the leg from higher up."
        )
    return slice(int(fast[0]), int(fast[-1]) + 1)


def cut(segment: Segment, part: slice) -> Segment:
    """The samples in `part`, with the time starting at 0 again."""
    kept = {name: samples[part] for name, samples in segment.channels().items()}
    extra = {name: cells[part] for name, cells in segment.extra_columns.items()}
    first = float(kept["time"][0])
    kept["time"] = kept["time"] - first
    return Segment(**kept, extra_columns=extra, begins=segment.begins + first)


def best_velocity(segment: Segment) -> Samples:
    """The filtered velocity [rad/s], else the gyro's mean over 50 ms, else the angle's slope."""
    if segment.angular_velocity is not None:
        return interpolated(segment.time, segment.angular_velocity)
    if segment.raw_angular_velocity is not None:
        return local_line(segment.time, segment.raw_angular_velocity, SMOOTHING)[0]
    return local_line(segment.time, segment.best_angle, SMOOTHING)[1]


def torque_frequencies(period: float) -> dict[str, float]:
    """The two readings of Eq. 4 [Hz]: its words say 1/T, its formula 2/T; T is the whole cycle."""
    return {"1/T": 1 / period, "2/T": 2 / period}


def runs(mask: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """First and last index of every stretch of True."""
    edges = (np.flatnonzero(mask[1:] != mask[:-1]) + 1).tolist()
    if mask[:1].any():
        edges.insert(0, 0)
    if mask[-1:].any():
        edges.append(mask.size)
    return [(a, b - 1) for a, b in zip(edges[::2], edges[1::2], strict=True)]


def stands(samples: Samples, fewest: int) -> list[tuple[int, int]]:
    """First and last sample of every stretch of one value that has at least so many."""
    each = [(first, last + 1) for first, last in runs(np.diff(samples) == 0.0)]
    return [(first, last) for first, last in each if last - first + 1 >= fewest]


def reversals(angle: Samples, least: float) -> list[int]:
    """Where a sequence turns around by at least `least`: the extremes between such turns."""
    found: list[int] = []
    low = high = 0
    falling: bool | None = None
    places = bends(angle)
    for at, value in zip(places.tolist(), angle[places].tolist(), strict=True):
        low, high = (at if value < angle[low] else low), (at if value > angle[high] else high)
        if falling is not False and value - angle[low] >= least:
            if falling:
                found.append(low)
            falling, high = False, at
        elif falling is not True and angle[high] - value >= least:
            if falling is False:
                found.append(high)
            falling, low = True, at
    return found


def classify(segment: Segment) -> Kind | None:
    """Swung out, whatever lifts the leg after that, or ended lower: a passive drop; back at its
    start: a voluntary cycle; a lift, still, or too few samples for ends and a middle: None.
    """
    known = known_angle(segment)
    angle = interpolated(segment.time, known)
    if angle.size <= 2 * ENDS or still(segment.time, angle):
        return None
    begin, end = (float(np.median(each)) for each in (angle[:ENDS], angle[-ENDS:]))
    rise = (end - begin) / np.ptp(angle)
    if rise <= -NEAR or swings_out(segment.time, angle, ~np.isnan(known)):
        return "passive"
    return "active" if rise < NEAR else None


def known_angle(segment: Segment) -> Samples:
    """The angle by the first channel that has one, without its wild samples."""
    channel = next(each for each in ANGLES if getattr(segment, each) is not None)
    return np.where(spikes_of(segment, channel, 0.0), np.nan, getattr(segment, channel))


def stays(segment: Segment) -> bool:
    """Does its angle stay where it is, but for noise?"""
    return still(segment.time, interpolated(segment.time, known_angle(segment)))


def still(time: Samples, angle: Samples) -> bool:
    return bool(np.ptp(local_line(time, angle, 2 * SMOOTHING)[0]) < STILL)


def swings_out(time: Samples, angle: Samples, seen: NDArray[np.bool_]) -> bool:
    """Does it begin with a fall and ever smaller swings? No muscle moves a leg like that.

    Where samples were not `seen`, the line over them hides turns: ever smaller swings before or
    after it are enough.
    """
    smooth = local_line(time, angle, 2 * SMOOTHING)[0]
    least = RINGING * float(np.ptp(smooth))
    if shrinking(smooth[[0, *reversals(smooth, least)]]):
        return True
    parts = [smooth[each] for each in unbroken(time, seen)]
    between = [part[reversals(part, least)] for part in parts[1:]]
    first = [part[[0, *reversals(part, least)]] for part in parts[:1]]
    each = (*first, *map(from_top, between))
    return len(parts) > 1 and any(shrinking(ends, LESS) for ends in each)


def unbroken(time: Samples, seen: NDArray[np.bool_]) -> list[slice]:
    """The stretches between the holes that no line bridges."""
    at = np.flatnonzero(seen)
    after = np.flatnonzero(np.diff(time[at]) > BRIDGED) + 1
    return [slice(int(part[0]), int(part[-1]) + 1) for part in np.split(at, after) if part.size]


def from_top(turns: Samples) -> Samples:
    """Turning angles from the first upper one on."""
    return turns[int(np.argmax(turns[:2])) :] if turns.size else turns


def shrinking(ends: Samples, most: float = 1.0) -> bool:
    """Are the swings between these angles ever smaller, less than `most` of the one before, and the
    first of them a fall?
    """
    swings = np.diff(ends)
    size = np.abs(swings)
    if size.size < FREE or swings[0] > 0:
        return False
    return bool((size[1:] < most * size[:-1]).all() and size[-1] < SHRUNK * size[0])
