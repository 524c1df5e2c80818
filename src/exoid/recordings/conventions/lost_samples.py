"""Samples of an angle that nobody measured: a value that is repeated while the leg moves on.

A logger that hears nothing writes zeros, or the last value once more. Neither is told by the value
but by its ends, where the angle jumps as it does nowhere beside, or by the gyro, which turns
meanwhile. What an encoder shows at rest is repeated as well, and stays.
"""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from exoid.files.text_file import Notes
from exoid.recordings.recording import Recording, Segment
from exoid.recordings.samples import Samples
from exoid.recordings.signal.condition import runs

FEWEST = 3  # times in a row; what is shorter is a spike
LEAST = float(np.radians(5.0))  # by which an angle jumps, or its gyro turns meanwhile
ALONE, BESIDE = 4.0, 5  # times the greatest of so many steps on its other side, of a jump
MOVES = 0.5  # rad/s in the mean, which is no gyro's bias
RATES = {"raw_angle": "raw_angular_velocity", "angle": "angular_velocity"}


def without_lost_samples(recording: Recording) -> tuple[Recording, Notes]:
    """The recording with NaN for what is repeated, and how much of it, said. What a rig's joint
    does is left as it is: one may be struck, and held.
    """
    if recording.subject.kind == "rig":
        return recording, ()
    found = [lost_in(segment) for segment in recording.segments]
    notes = tuple(filter(None, map(told, recording.segments, found)))
    if not notes:
        return recording, ()
    return replace(recording, segments=tuple(map(without, recording.segments, found))), notes


def lost_in(segment: Segment) -> dict[str, NDArray[np.bool_]]:
    """Which samples of every channel of the angle nobody measured."""
    channels = segment.channels()
    return {
        name: lost(segment.time, channels[name], channels.get(rate))
        for name, rate in RATES.items()
        if name in channels
    }


def lost(time: Samples, angle: Samples, rate: Samples | None) -> NDArray[np.bool_]:
    """Which samples of an angle [rad] repeat a value that it jumps to or from, or while it turns by
    its rate [rad/s].
    """
    found = np.zeros(angle.size, dtype=bool)
    steps = np.abs(np.diff(angle))
    for first, last in repeated(angle):
        before, after = steps[max(first - 1 - BESIDE, 0) : first][::-1], steps[last - 1 :]
        moves = rate is not None and turns(time[first:last], rate[first:last])
        found[first:last] = moves or jumps(before) or jumps(after[: BESIDE + 1])
    return found


def repeated(samples: Samples) -> list[tuple[int, int]]:
    """Where a value is the same at least FEWEST times: from the first to behind the last."""
    each = [(first, last + 2) for first, last in runs(np.diff(samples) == 0.0)]
    return [(first, behind) for first, behind in each if behind - first >= FEWEST]


def jumps(steps: Samples) -> bool:
    """Is the first step a jump, beside those that follow?"""
    if steps.size < 2 or np.isnan(steps).all():
        return False
    return bool(steps[0] > max(LEAST, ALONE * np.nanmax(steps[1:], initial=0.0)))


def turns(time: Samples, rate: Samples) -> bool:
    """Does a gyro turn meanwhile?"""
    turned = abs(float(np.nansum((rate[1:] + rate[:-1]) / 2 * np.diff(time))))
    return turned > max(LEAST, MOVES * float(time[-1] - time[0]))


def without(segment: Segment, lost: dict[str, NDArray[np.bool_]]) -> Segment:
    """The segment with NaN for what nobody measured."""
    channels = segment.channels()
    left = {name: np.where(mask, np.nan, channels[name]) for name, mask in lost.items()}
    return replace(segment, **left)


def told(segment: Segment, lost: dict[str, NDArray[np.bool_]]) -> str:
    """How many samples are left out, and when; nothing where none is."""
    places = np.flatnonzero(np.logical_or.reduce([*lost.values()]))
    if not places.size:
        return ""
    first, last = segment.begins + segment.time[places[[0, -1]]]
    return (
        f"{places.size} samples of the angle between {first:.2f} and {last:.2f} s repeat a value "
        "while the leg moves on, as where none was measured: they are left out. Leave such cells "
        "empty."
    )
