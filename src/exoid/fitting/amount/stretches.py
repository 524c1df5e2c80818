"""Which stretch of a long segment is fitted: what moves, and of that as much as a fit takes."""

import numpy as np

from exoid.fitting.amount.part import Part, together
from exoid.fitting.data.pace import LONGEST_STEP
from exoid.recordings.conventions.thin import of_means
from exoid.recordings.measured.samples import Samples, block_size
from exoid.recordings.measured.segment import Segment
from exoid.recordings.motion.find_free import moving
from exoid.recordings.motion.signal import signal_of, smoothed, speed_of
from exoid.recordings.motion.thresholds import CLEAR, KEPT, REST_KEPT, TRAVEL
from exoid.recordings.signal.condition import cut

COARSE = 0.02  # s, over which samples are averaged to see what moves
AFTER = KEPT + 0.5  # s of rest behind a movement: what a fit keeps of it, and room to see it
WINDOWS = 8  # of a segment that is driven all along: its torque may differ from hour to hour
LEAST = 256  # samples of a window


def moving_parts(parts: list[Part]) -> list[Part]:
    """The same without the rests before and after; what a torque drives is kept, rest and all."""
    return together(parts, [[moving_part(each)] for each in parts])


def moving_part(part: Part) -> Segment:
    segment = part.segment
    if part.kind == "measured":
        return segment
    span = moving_span(part)
    if span is None:
        return segment
    first, last = span
    period = part.recording.cycle_period(part.number)
    if period is not None and part.kind == "active":
        last = min(last, first + period)
    inside = (segment.time >= first - REST_KEPT) & (segment.time <= last + AFTER)
    return cut(segment, run(inside))


def moving_span(part: Part) -> tuple[float, float] | None:
    """When a segment begins to move and comes to rest [s]; None where nothing is seen to."""
    step = float(np.median(np.diff(part.segment.time)))
    signal = signal_of(of_means(part.segment, block_size(step, COARSE)), part.recording.sensors)
    speed = speed_of(signal)
    smooth, noise = smoothed(signal, speed.width)
    least = max(TRAVEL, CLEAR * noise)
    far = [
        (first, last)
        for first, last in moving(signal.time, speed)
        if np.ptp(smooth[max(first - 1, 0) : last + 2]) > least
    ]
    return (signal.time[far[0][0]], signal.time[far[-1][1]]) if far else None


def run(inside) -> slice:
    at = np.flatnonzero(inside)
    return slice(int(at[0]), int(at[-1]) + 1)


def shortened(parts: list[Part], most: int) -> tuple[list[Part], dict[str, str]]:
    """The parts with at most so many steps each, and of those that were longer what is fitted.

    A leg that was let go tells most in its first swings: they are kept. What a torque drives is
    fitted in windows over all of it, of which each begins anew.
    """
    windows = int(np.clip(most // LEAST, 1, WINDOWS))
    made, said = [], {}
    for part in parts:
        if part.steps <= most:
            made.append([part.segment])
        elif part.kind == "measured":
            made.append(windows_of(part.segment, windows, most // windows))
            said[part.name] = f"{len(made[-1])} windows of {lasting(made[-1][0])}"
        else:
            made.append([cut(part.segment, slice(0, reach(part.segment.time, 0, most)))])
            said[part.name] = f"the first {lasting(made[-1][0])}"
    return together(parts, made), said


def windows_of(segment: Segment, count: int, size: int) -> list[Segment]:
    """So many windows of about `size` steps, evenly over the segment."""
    starts = np.linspace(0, segment.time.size - 1 - min(size, segment.time.size - 1), count)
    each = [slice(int(at), reach(segment.time, int(at), size)) for at in starts]
    return [cut(segment, one) for one in each if one.stop - one.start > 1]


def reach(time: Samples, start: int, most: int) -> int:
    """One past the last sample that `most` steps from `start` on reach."""
    steps = np.maximum(np.ceil(np.diff(time[start:]) / LONGEST_STEP - 1e-6), 1)
    return start + int(np.searchsorted(np.cumsum(steps), most - 1, side="right")) + 1


def lasting(segment: Segment) -> str:
    return f"{segment.time[-1] - segment.time[0]:.3g} s"
