"""Times of samples that were taken evenly and stamped otherwise: a buffer is read late, and all in
it at once, or a computer stamps each when it comes to it.

The sensor measured evenly all the while. No sample is stamped before it was taken, so that the line
below the times, over the number of the sample, has its clock. Batches are seen in the times; else
the samples say by which times they scatter less about what their neighbours say.
"""

from dataclasses import replace

import numpy as np

from exoid.files.text_file import Notes
from exoid.recordings.measured.samples import Samples, robust_deviation
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from exoid.recordings.signal.neighbours import interpolation_errors

SHORT, MANY = 0.35, 0.2  # of the mean step, and of all steps, that are so short
LATE = 10.0  # mean steps that a sample waits at most: what waits longer was not there
FEWEST = 50  # samples
ROUNDS = 6  # in which the later half is left out
EVEN = 1e-2  # of a step, in all: times that are even already
CHANNELS = ("raw_angle", "angle", "raw_angular_velocity")
LESS, SURE = 0.9, 5.0  # of the scatter; over the root of its samples, 3 errors of such a ratio


def unbatched(recording: Recording) -> tuple[Recording, Notes]:
    """The recording with even times where its samples were taken evenly, said."""
    found = [even_times(each.time) for each in recording.segments]
    why = "samples come in batches, as from a buffer that is read late"
    if all(each is None for each in found):
        found = [line_below(each.time) for each in recording.segments]
        why = "times are off, each by its own, for samples scatter less by even ones"
        if not scatters_less(recording, found):
            return recording, ()
    segments = [
        each if even is None else of_times(each, even)
        for each, even in zip(recording.segments, found, strict=True)
    ]
    steps = [1e3 * float(even[1] - even[0]) for even in found if even is not None]
    note = (
        f"{why}: they are taken for evenly apart, by {np.mean(steps):.4g} ms. Record times by the "
        "sensor's own clock."
    )
    return replace(recording, segments=tuple(segments)), (note,)


def of_times(segment: Segment, time: Samples) -> Segment:
    """The segment on another clock, which begins at 0."""
    return replace(segment, time=time - time[0], begins=segment.begins + float(time[0]))


def even_times(time: Samples) -> Samples | None:
    """The times at which samples were taken that come in batches; None where they do not."""
    mean = (time[-1] - time[0]) / (time.size - 1)
    return None if np.mean(np.diff(time) < SHORT * mean) < MANY else line_below(time)


def line_below(time: Samples) -> Samples | None:
    """Even times that no sample is stamped before; None where these are, or one waits too long."""
    if time.size < FEWEST:
        return None
    mean = (time[-1] - time[0]) / (time.size - 1)
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
    return even if EVEN * mean < np.ptp(late) < LATE * mean and even[1] > even[0] else None


def scatters_less(recording: Recording, found: list[Samples | None]) -> bool:
    """Does a channel clearly scatter less by these times, and none more?"""
    told = [each for each, even in zip(recording.segments, found, strict=True) if even is not None]
    stamps, evens = [each.time for each in told], [even for even in found if even is not None]
    clear = False
    for name in CHANNELS:
        signals = [samples for each in told if (samples := getattr(each, name)) is not None]
        errors = errors_of(evens, signals) if len(signals) == len(told) else np.empty(0)
        if errors.size < FEWEST:
            continue
        less = robust_deviation(errors) / robust_deviation(errors_of(stamps, signals))
        if less > 1:
            return False
        clear |= bool(less < min(LESS, 1 - SURE / np.sqrt(errors.size)))
    return clear


def errors_of(times: list[Samples], signals: list[Samples]) -> Samples:
    """By how much samples depart from what their neighbours say."""
    found = [interpolation_errors(*each) for each in zip(times, signals, strict=True)]
    errors = np.concatenate([np.empty(0), *found])
    return errors[~np.isnan(errors)]
