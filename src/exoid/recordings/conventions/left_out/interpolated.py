"""Values on straight lines between others, as where a slow sensor was written at a faster rate.

What is measured scatters about the line between its neighbours, by its noise and as a leg bends its
path. A value that was made by interpolation lies on it to the last digit that is written, and what
does not was measured: at every so many samples, which by chance are far from so regular.
"""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from exoid.files.text_file import Notes
from exoid.recordings.conventions.left_out.held_values import FEWEST, NAMES, REGULAR, said_once
from exoid.recordings.measured.samples import ROUNDING, Samples
from exoid.recordings.recording import Recording

ON_LINE = 1.01  # written steps: three rounded values, half a step each, one at double weight
BENT = 5.0  # written steps, that what was measured is off its line at the least
Mask = NDArray[np.bool_]


def without_interpolated(recording: Recording) -> tuple[Recording, Notes]:
    """The recording with what was measured alone, and which channels had more, said."""
    found = {name: own for name in NAMES if (own := made_in(recording, name)) is not None}
    if not found:
        return recording, ()
    segments = [
        said_once(segment, {name: made[number] for name, (made, _) in found.items()})
        for number, segment in enumerate(recording.segments)
    ]
    notes = tuple(told(name, often) for name, (_, often) in found.items())
    return replace(recording, segments=tuple(segments)), notes


def made_in(recording: Recording, name: str) -> tuple[list[Mask], int] | None:
    """Which samples of a channel lie between measured ones, one of so many; None where none do."""
    signals = [getattr(each, name) for each in recording.segments]
    if any(each is None for each in signals):
        return None
    step = written_step(signals)
    if step == np.inf:  # a signal that stays at one value
        return None
    apart = [
        off_line(each.time, own) / step
        for each, own in zip(recording.segments, signals, strict=True)
    ]
    inner = [each[np.isfinite(each)] for each in apart]
    lengths = np.concatenate([np.diff(np.flatnonzero(each > ON_LINE)) for each in inner])
    if lengths.size < FEWEST:
        return None
    often, sizes = int(np.bincount(lengths).argmax()), np.concatenate(inner)
    sharp = np.median(sizes[sizes > ON_LINE]) > BENT
    if often < 2 or np.mean(lengths == often) < REGULAR or not sharp:
        return None
    return [~(each > ON_LINE) for each in apart], often


def written_step(signals: list[Samples]) -> float:
    """By which two values differ at the least, beyond the rounding of a computer."""
    values = np.unique(np.concatenate(signals))
    steps = np.diff(values[~np.isnan(values)])
    return float(steps[steps > ROUNDING].min(initial=np.inf))


def off_line(time: Samples, samples: Samples) -> Samples:
    """How far every sample is from the line between its neighbours that are known; the first and
    the last are on none.
    """
    known = np.flatnonzero(~np.isnan(samples))
    at, seen = time[known], samples[known]
    before, after = at[1:-1] - at[:-2], at[2:] - at[1:-1]
    line = (seen[:-2] * after + seen[2:] * before) / (before + after)
    off = np.where(np.isnan(samples), np.nan, np.inf)
    off[known[1:-1]] = np.abs(seen[1:-1] - line)
    return off


def told(name: str, often: int) -> str:
    return (
        f"{often - 1} of {often} values of the {NAMES[name]} lie on straight lines between the "
        "others, as where a slow sensor was interpolated: what was measured alone counts. Record "
        "every sample once, by the sensor's own clock."
    )
