"""Conditioning of what was measured: the moving average (Eq. 3), clipping, splitting a continuous
log into movements, and the frequency of the driving torque (Eq. 4).
"""

from dataclasses import replace
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from exoid.recording.recording import Kind, Protocol, Recording, Samples, Segment

MOTION_SPEED = np.radians(20.0)  # rad/s, the paper's criterion of significant motion
REST_SPEED = np.radians(5.0)  # rad/s, below it the leg is held; twitches and a gyro's bias fit in
REST_DURATION = 0.3  # s, longer than any turning point of a cycle below about 7 s
SMOOTHING = 0.05  # s, of the velocity that decides what moves; half a leg's swing takes 0.5 s
REST_KEPT = 0.5  # s of rest in front of each movement
NEAR = 0.35  # of the range of a movement; a drop ends at 0.5 (no damping) to 1 of it, lower

Signal = Any  # a NumPy or a JAX array, time first
Marks = tuple[float, ...]  # s, on the log's clock


def moving_average(samples: Signal, window: int) -> Signal:
    """T(i) = 1/h (phi(i) + ... + phi(i + h - 1)), Eq. 3 with h = `window`, full windows only.

    The result has `window - 1` samples fewer and belongs to the times of `window_time`. It is
    linear, takes NumPy and JAX arrays, and a missing sample spoils the windows that hold it.
    """
    count = samples.shape[0] - window + 1
    if window < 1 or count < 1:
        raise ValueError(
            f"a moving average over {window} samples does not fit a record of {samples.shape[0]}; "
            f"choose a window between 1 and {samples.shape[0]}."
        )
    return sum(samples[lag : lag + count] for lag in range(window)) / window


def window_time(time: Signal, window: int, *, centred: bool) -> Signal:
    """The times [s] at which averaged samples are stamped.

    Centred: the middle of each window, no lag. Else its first sample, as published: the motion
    then appears (window - 1) / 2 samples early.
    """
    middle = moving_average(time, window)
    return middle if centred else time[: middle.shape[0]]


def average_segment(segment: Segment, window: int, *, centred: bool) -> Segment:
    """Eq. 3 applied to every channel of a segment."""
    averaged = {name: moving_average(s, window) for name, s in segment.channels().items()}
    return Segment(**averaged | {"time": window_time(segment.time, window, centred=centred)})


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
    return Segment(**kept | {"time": kept["time"] - kept["time"][0]}, extra_columns=extra)


def best_velocity(segment: Segment) -> Samples:
    """The filtered velocity [rad/s], else the gyro's mean over 50 ms, else the angle's slope."""
    if segment.angular_velocity is not None:
        return interpolated(segment.time, segment.angular_velocity)
    if segment.raw_angular_velocity is not None:
        return local_line(segment.time, segment.raw_angular_velocity, SMOOTHING)[0]
    angle = next(a for a in (segment.raw_angle, segment.angle) if a is not None)
    return local_line(segment.time, angle, SMOOTHING)[1]


def local_line(time: Samples, samples: Samples, width: float) -> tuple[Samples, Samples]:
    """Value and slope at every sample of the straight line fitted to the `width` s around it.

    Missing samples are bridged; sums run over the window, so uneven sampling does no harm.
    """
    filled = interpolated(time, samples)
    first = np.searchsorted(time, time - width / 2)
    last = np.searchsorted(time, time + width / 2, side="right")
    first = np.minimum(first, np.maximum(last - 3, 0))  # three samples carry a line and a check
    last = np.minimum(np.maximum(last, first + 3), time.size)

    def window_sum(of: Samples) -> Samples:
        total = np.concatenate([[0.0], np.cumsum(of)])
        return total[last] - total[first]

    count = last - first
    middle, mean = window_sum(time) / count, window_sum(filled) / count
    spread = window_sum(time**2) / count - middle**2
    slope = (window_sum(time * filled) / count - middle * mean) / spread
    return mean + slope * (time - middle), slope


def interpolated(time: Signal, samples: Signal) -> Samples:
    known = ~np.isnan(samples)
    return np.interp(time, time[known], samples[known])


def torque_frequencies(period: float) -> dict[str, float]:
    """The two readings of Eq. 4 [Hz]: its words say 1/T, its formula 2/T; T is the whole cycle."""
    return {"1/T": 1 / period, "2/T": 2 / period}


def movements(segment: Segment) -> list[slice]:
    """The movements between rests, each from its onset to its return.

    A rest is at least 0.3 s below 5 deg/s, or any such stretch at the ends of the record. The
    onset is the last sample at rest, the return the first, and between them 20 deg/s is passed.
    """
    time, speed = segment.time, np.abs(best_velocity(segment))
    last, moving = time.size - 1, np.ones(time.size, dtype=bool)
    for first, end in runs(speed < REST_SPEED):
        if time[end] - time[first] >= REST_DURATION or first == 0 or end == last:
            moving[first : end + 1] = False
    return [
        slice(max(first - 1, 0), min(end + 1, last) + 1)
        for first, end in runs(moving)
        if (speed[first : end + 1] > MOTION_SPEED).any()
    ]


def runs(mask: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """First and last index of every stretch of True."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], mask, [False]])))
    return [(int(a), int(b) - 1) for a, b in zip(edges[::2], edges[1::2], strict=True)]


def classify(segment: Segment) -> Kind | None:
    """Back at its start: a voluntary cycle; ended lower: a passive drop; a lift or still: None."""
    measured = next(a for a in (segment.angle, segment.raw_angle) if a is not None)
    angle = interpolated(segment.time, measured)
    if np.ptp(angle) == 0:
        return None
    rise = (angle[-1] - angle[0]) / np.ptp(angle)
    if abs(rise) < NEAR:
        return "active"
    return "passive" if rise < 0 else None


def measure_period(segment: Segment) -> float:
    """The time [s] from the onset of the first movement to the return of the last; nan if still."""
    found = movements(segment)
    if not found:
        return np.nan
    return float(segment.time[found[-1].stop - 1] - segment.time[found[0].start])


def split(recording: Recording) -> Recording:
    """A log of one segment, cut into its cycles and drops; anything else is returned as it is.

    `protocol.segment_start` and `segment_end` say where, when given [s on the log's clock].
    Otherwise rests separate movements, each keeps up to 0.5 s of the rest before it, and lifts
    between drops are left out. Kind and cycle period are filled in where the sidecar is silent.
    """
    log, *others = recording.segments
    if others:
        return recording
    protocol = recording.protocol
    starts, ends = protocol.segment_start, protocol.segment_end
    seen = replace(log, angular_velocity=best_velocity(log))
    parts = find_parts(seen) if starts is None else marked_parts(log, starts, ends)
    described = describe(protocol, [cut(seen, part) for part in parts])
    return replace(recording, segments=tuple(cut(log, part) for part in parts), protocol=described)


def marked_parts(log: Segment, starts: Marks, ends: Marks | None) -> list[slice]:
    """The samples between the marks; without end marks each segment lasts until the next."""
    parts = []
    ends = ends or (*starts[1:], float(log.time[-1]))
    for number, (start, end) in enumerate(zip(starts, ends, strict=True)):
        inside = np.flatnonzero((log.time >= start) & (log.time <= end))
        if inside.size < 2:
            raise ValueError(
                f"segment {number} is marked from {start:g} to {end:g} s, where the log has "
                f"{inside.size} sample(s); it runs from {log.time[0]:g} to {log.time[-1]:g} s."
            )
        parts.append(slice(int(inside[0]), int(inside[-1]) + 1))
    return parts


def find_parts(log: Segment) -> list[slice]:
    """Every movement but the lifts, with the rest before it."""
    parts = []
    for before, movement in pairwise([slice(0, 0), *movements(log)]):
        rest = np.searchsorted(log.time, log.time[movement.start] - REST_KEPT)
        parts.append(slice(max(int(rest), before.stop), movement.stop))
    parts = [part for part in parts if classify(cut(log, part)) is not None]
    if not parts:
        raise ValueError(
            "no movement was found: no drop or cycle passes 20 deg/s between two rests. "
            "Mark the segments with segment_start_s and segment_end_s."
        )
    return parts


def describe(protocol: Protocol, segments: list[Segment]) -> Protocol:
    """The protocol of the segments, the marks gone and what was missing filled in."""
    kind = protocol.kind or tuple(classify(segment) or "passive" for segment in segments)
    period = protocol.cycle_period
    if period is None and "active" in kind:
        kinds = kind if isinstance(kind, tuple) else (kind,) * len(segments)
        period = tuple(
            measure_period(segment) if each == "active" else np.nan
            for each, segment in zip(kinds, segments, strict=True)
        )
    return replace(protocol, kind=kind, cycle_period=period, segment_start=None, segment_end=None)
