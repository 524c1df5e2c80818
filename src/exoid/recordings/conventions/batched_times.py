"""Times of samples that come in batches: a buffer is read late, and all in it at once.

The sensor measured evenly all the while. No sample is stamped before it was taken, so that the line
below the times, over the number of the sample, has its clock.
"""

from dataclasses import replace

import numpy as np

from exoid.files.text_file import Notes
from exoid.recordings.recording import Recording, Segment
from exoid.recordings.samples import Samples

SHORT, MANY = 0.35, 0.2  # of the mean step, and of all steps, that are so short
LATE = 10.0  # mean steps that a sample waits at most: what waits longer was not there
FEWEST = 50  # samples
ROUNDS = 6  # in which the later half is left out


def unbatched(recording: Recording) -> tuple[Recording, Notes]:
    """The recording with even times where its samples come in batches, said."""
    found = [even_times(each.time) for each in recording.segments]
    if all(each is None for each in found):
        return recording, ()
    segments = [
        each if even is None else of_times(each, even)
        for each, even in zip(recording.segments, found, strict=True)
    ]
    steps = [1e3 * float(even[1] - even[0]) for even in found if even is not None]
    note = (
        f"samples come in batches, as from a buffer that is read late: they are taken for evenly "
        f"apart, by {np.mean(steps):.4g} ms. Record times by the sensor's own clock."
    )
    return replace(recording, segments=tuple(segments)), (note,)


def of_times(segment: Segment, time: Samples) -> Segment:
    """The segment on another clock, which begins at 0."""
    return replace(segment, time=time - time[0], begins=segment.begins + float(time[0]))


def even_times(time: Samples) -> Samples | None:
    """The times at which samples were taken that come in batches; None where they do not."""
    if time.size < FEWEST:
        return None
    mean = (time[-1] - time[0]) / (time.size - 1)
    if np.mean(np.diff(time) < SHORT * mean) < MANY:
        return None
    number = np.arange(time.size, dtype=float)
    soon = np.ones(time.size, dtype=bool)
    even = time
    for _ in range(ROUNDS):
        slope, level = np.polyfit(number[soon], time[soon], 1)
        even = level + slope * number
        soon &= time - even <= np.median((time - even)[soon])
        if soon.sum() < FEWEST // 5:
            break
    late = time - even
    return even if np.ptp(late) < LATE * mean and even[1] > even[0] else None
