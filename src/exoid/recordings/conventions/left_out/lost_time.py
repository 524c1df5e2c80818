"""Time that a clock does not know of: samples are lost, or the recording paused, and the next row
was counted as if nothing had happened. The motion breaks off there.
"""

from dataclasses import replace
from functools import partial
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from exoid.files.text_file import Notes
from exoid.recordings.conventions.left_out.breaks import breaks
from exoid.recordings.measured.samples import Samples
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from exoid.recordings.signal.condition import cut
from exoid.recordings.signal.local_line import interpolated

TIME_LOST = "samples are lost"  # by which a note of it is known


def without_lost_time(recording: Recording) -> tuple[Recording, Notes]:
    """The recording, every segment in which time is lost cut to the piece in which the leg goes
    farthest, and where that is, said. What a rig's joint does is left as it is: it may be struck.
    """
    if recording.subject.kind == "rig":
        return recording, ()
    segments, notes = [], []
    for number, segment in enumerate(recording.segments):
        lost = lost_time(segment)
        kept = farthest(segment, lost)
        segments.append(cut(segment, kept) if lost.size else segment)
        notes += [told(number, segment, lost, kept)] if lost.size else []
    return replace(recording, segments=tuple(segments)) if notes else recording, tuple(notes)


def lost_time(segment: Segment) -> NDArray[np.int_]:
    """The samples before which time is lost, as the sensors tell: a filter's channels go on."""
    if segment.raw_angle is None:
        return np.zeros(0, dtype=int)
    known = np.flatnonzero(~np.isnan(segment.raw_angle))
    rate = segment.raw_angular_velocity
    if rate is not None:
        rate = interpolated(segment.time, rate)[known]
    return known[breaks(segment.time[known], segment.raw_angle[known], rate)]


def farthest(segment: Segment, lost: NDArray[np.int_]) -> slice:
    """The piece between losses in which the angle goes farthest."""
    ends = [0, *lost.tolist(), segment.time.size]
    return max((slice(*each) for each in pairwise(ends)), key=partial(travel, segment.best_angle))


def travel(angle: Samples, part: slice) -> float:
    known = angle[part][~np.isnan(angle[part])]
    return float(np.ptp(known)) if known.size else 0.0


def told(number: int, segment: Segment, lost: NDArray[np.int_], kept: slice) -> str:
    """Where time is lost, and which piece of the segment is used."""
    clock = segment.begins + segment.time
    where = ", ".join(f"{at:.2f}" for at in clock[lost])
    first, last = clock[[kept.start, kept.stop - 1]]
    return (
        f"{TIME_LOST} at {where} s, in segment {number}: the clock went on without them, while "
        f"angle and speed jump. {first:.2f} to {last:.2f} s of it are used. Record it again, or "
        "give every row the time at which it was measured."
    )
