"""Values that stand more than once, as where a logger is faster than its sensor.

Where a signal moves by more than its sensor's step from value to value, no two in a row are
alike by themselves. What an encoder shows at rest is alike, and so are values that were lost now
and then, of which there are few: see `lost_samples`.
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from exoid.files.text_file import Notes
from exoid.recordings.conventions.left_out.held_late import Beat, beat_of, on_time
from exoid.recordings.measured.samples import Samples, quantile, usual_step
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording

AROUND = 0.05  # s to either side, over which a signal moves; a leg's swing takes 0.6 s
ROUNDED = 0.05  # of the median change of a value: what changes by less was rounded
FINE, FASTER = 0.1, 2.0  # of the changes, that are no more than a sensor's step; times that
MANY = 0.25  # of the samples where it moves, that repeat the one before: by chance at most 0.06 do
REGULAR = 0.9  # of the runs of one value, that are of one length or of the next
FEWEST = 30  # samples where it moves
NAMES = {
    "raw_angle": "angle",
    "angle": "filtered angle",
    "raw_angular_velocity": "gyro",
    "angular_velocity": "filtered velocity",
}
Mask = NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class Held:
    """How a channel repeats its values."""

    often: int  # times that one stands in a row
    repeats: list[Mask]  # of every segment, which samples only say again what was said
    beats: list[Beat | None]  # how its values come, where that is not at every so many samples


def without_held(recording: Recording) -> tuple[Recording, Notes]:
    """The recording with every value once where a channel holds its values, and which do, said.

    It stays where it stands first. A sample in which no channel says anything new is left out.
    """
    found = {name: held for name in NAMES if (held := held_in(recording, name)) is not None}
    if not found:
        return recording, ()
    segments = [
        said_once(
            moved_on(segment, number, found),
            {name: held.repeats[number] for name, held in found.items()},
        )
        for number, segment in enumerate(recording.segments)
    ]
    return replace(recording, segments=tuple(segments)), tuple(map(told, found, found.values()))


def held_in(recording: Recording, name: str) -> Held | None:
    """How a channel repeats its values; None where it does not, or by chance."""
    found = [(each.time, getattr(each, name)) for each in recording.segments]
    signals = [samples for _, samples in found if samples is not None]
    step = sensor_step(signals) if len(signals) == len(found) else None
    if step is None:
        return None
    moves = [moving(*each, FASTER * step) for each in found]
    starts = [beginning(each) for each in signals]
    lengths = np.concatenate([of_runs(*each) for each in zip(starts, moves, strict=True)])
    if lengths.sum() < FEWEST or 1 - lengths.size / lengths.sum() < MANY:
        return None
    least, often = np.floor(lengths.mean()), int(np.ceil(lengths.mean()))
    if np.mean((lengths == least) | (lengths == least + 1)) < REGULAR:
        return None
    each = list(zip(starts, moves, strict=True))
    beats = [beat_of(time, *own) for (time, _), own in zip(found, each, strict=True)]
    return Held(often, [repeated(*own, often) for own in each], beats)


def moved_on(segment: Segment, number: int, found: dict[str, Held]) -> Segment:
    """The segment, its values as they were at the times at which they stand first."""
    channels = segment.channels()
    changed = {
        name: on_time(segment.time, channels[name], ~held.repeats[number], own)
        for name, held in found.items()
        if (own := held.beats[number]) is not None
    }
    return replace(segment, **changed)


def sensor_step(signals: list[Samples]) -> float | None:
    """No more than what a signal changes by, where it does; None where it hardly ever does."""
    changes = np.abs(np.concatenate([np.diff(each) for each in signals]))
    changes = changes[changes > 0]
    if changes.size < FEWEST:
        return None
    return quantile(changes[changes > ROUNDED * quantile(changes)], FINE)


def moving(time: Samples, samples: Samples, least: float) -> Mask:
    """Where a signal moves by more than `least` from value to value, on average around it."""
    reach = max(round(AROUND / usual_step(time)), 2)
    found = np.zeros(samples.size, dtype=bool)
    values = np.cumsum(beginning(samples))
    far = np.abs(samples[2 * reach :] - samples[: -2 * reach])
    found[reach : reach + far.size] = far > least * (values[2 * reach :] - values[: -2 * reach])
    return found


def beginning(samples: Samples) -> Mask:
    """Which samples are not as the one before."""
    return np.concatenate([[True], samples[1:] != samples[:-1]])


def of_runs(starts: Mask, moves: Mask) -> NDArray[np.int_]:
    """How often a value stands in a row, of those that stand where the signal moves: all along, for
    at the end of its range, or where it turns, it stands by itself.
    """
    at = np.flatnonzero(starts)
    return np.diff(at, append=starts.size)[np.logical_and.reduceat(moves, at)]


def repeated(starts: Mask, moves: Mask, often: int) -> Mask:
    """Which samples repeat the one before: all where the signal moves; and at rest, where values
    are alike by themselves, all but one of so many.
    """
    number = np.arange(starts.size)
    place = number - np.maximum.accumulate(np.where(starts, number, 0))
    return ~starts & (moves | (place % often != 0))


def said_once(segment: Segment, repeats: dict[str, Mask]) -> Segment:
    """The segment without what its channels only repeat."""
    channels = segment.channels()
    channels |= {name: np.where(mask, np.nan, channels[name]) for name, mask in repeats.items()}
    new = ~np.logical_and.reduce([np.isnan(channels[name]) for name in NAMES if name in channels])
    words = {
        name: tuple(cell for cell, stays in zip(cells, new, strict=True) if stays)
        for name, cells in segment.extra_columns.items()
    }
    kept = {name: samples[new] for name, samples in channels.items()}
    return replace(segment, **kept, extra_columns=words)


def told(name: str, held: Held) -> str:
    rates = [1 / each.period for each in held.beats if each is not None]
    come = f"come at {np.median(rates):.3g} Hz and " if rates else ""
    late = ", and brought there from when it was measured" if rates else ""
    return (
        f"values of the {NAMES[name]} {come}stand {held.often} times in a row, as where a logger "
        f"is faster than its sensor: each is taken once, where it stands first{late}. Record every "
        "sample once, by the sensor's own clock."
    )
