"""Samples that nobody measured: what is repeated, or a gyro's zero, while the leg moves on.

A logger that hears nothing writes zeros, or the last value once more. Neither is told by the value
but by its ends, where the angle jumps as it does nowhere beside, or by the gyro, which turns
meanwhile. What an encoder shows at rest is repeated as well, and stays. A gyro's zeros are told by
the encoder, and by its own rates before and after. A value that is repeated once or twice is told
by all channels, which no noise lets stand together while the angle goes on.
"""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from exoid.files.text_file import Notes
from exoid.recordings.measured.samples import Samples
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from exoid.recordings.signal.condition import runs, stands
from exoid.recordings.signal.rounding import least_step

FEWEST = 3  # times in a row; what is shorter is a spike, or stands in all channels
STEPS = 3.0  # of the code of an angle, by which it goes on from sample to sample, at least
LEAST = float(np.radians(5.0))  # by which an angle jumps, or its gyro turns meanwhile
ALONE, BESIDE = 4.0, 5  # times the greatest of so many steps on its other side, of a jump
MOVES = 0.5  # rad/s in the mean, which is no gyro's bias
GYRO = "raw_angular_velocity"
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
    """Which samples of every channel nobody measured."""
    channels = segment.channels()
    found = {
        name: lost(segment.time, channels[name], channels.get(rate))
        for name, rate in RATES.items()
        if name in channels
    }
    if segment.raw_angle is not None and segment.raw_angular_velocity is not None:
        rate = segment.raw_angular_velocity
        found["raw_angle"] |= written_again(segment.raw_angle, rate)
        again = found["raw_angle"] & (np.diff(rate, prepend=np.nan) == 0.0)
        found[GYRO] = again | zeros(segment.time, segment.raw_angle, rate)
    return found


def written_again(angle: Samples, rate: Samples) -> NDArray[np.bool_]:
    """Which samples of an angle [rad] and a gyro repeat the one before, both, though the angle goes
    one way by several codes from sample to sample, on average over those beside.
    """
    again = (np.diff(angle, prepend=np.nan) == 0.0) & (np.diff(rate, prepend=np.nan) == 0.0)
    if not again.any():
        return again
    number = np.arange(angle.size)
    first, last = np.maximum(number - BESIDE, 0), np.minimum(number + BESIDE, angle.size - 1)
    went = angle - angle[first], angle[last] - angle
    least = STEPS * BESIDE * least_step(angle[~np.isnan(angle)])
    return (
        again
        & (np.minimum(np.abs(went[0]), np.abs(went[1])) > least)
        & (np.sign(went[0]) == np.sign(went[1]))
    )


def zeros(time: Samples, angle: Samples, rate: Samples) -> NDArray[np.bool_]:
    """Which samples of a gyro [rad/s] are zero though it turns one way before and after, and the
    angle [rad] goes on meanwhile.
    """
    found = np.zeros(rate.size, dtype=bool)
    for first, last in runs(rate == 0.0):
        if first > 0 and last + 1 < rate.size:
            before, after = slice(max(first - BESIDE, 0), first), slice(last + 1, last + 1 + BESIDE)
            slope = slope_between(time, angle, before, after)
            found[first : last + 1] = goes_on(rate[first - 1], rate[last + 1], slope)
    return found


def slope_between(time: Samples, angle: Samples, before: slice, after: slice) -> float:
    """From the middle of some samples to that of others, whatever single ones show [rad/s]; nan
    where none is known.
    """
    if np.isnan(angle[before]).all() or np.isnan(angle[after]).all():
        return np.nan
    went = float(np.nanmedian(angle[after]) - np.nanmedian(angle[before]))
    return went / float(np.median(time[after]) - np.median(time[before]))


def goes_on(before: float, after: float, slope: float) -> bool:
    """Do two rates go one way, and a slope between them no less than half as fast?"""
    way = np.sign(before)
    return bool(min(way * before, way * after) > MOVES and way * slope > abs(before + after) / 4)


def lost(time: Samples, angle: Samples, rate: Samples | None) -> NDArray[np.bool_]:
    """Which samples of an angle [rad] repeat a value that it jumps to or from, or while it turns by
    its rate [rad/s] and is there at once when they end: with play it goes on from where it stood.
    """
    found = np.zeros(angle.size, dtype=bool)
    steps = np.abs(np.diff(angle))
    for first, last in repeated(angle):
        before, after = steps[max(first - 1 - BESIDE, 0) : first][::-1], steps[last - 1 :]
        stood = slice(first, last)
        turned = 0.0 if rate is None else turns(time[stood], rate[stood])
        moves = turned > 0.0 and (after.size == 0 or not after[0] < MOVES * turned)
        found[first:last] = moves or jumps(before) or jumps(after[: BESIDE + 1])
    return found


def repeated(samples: Samples) -> list[tuple[int, int]]:
    """Where a value is the same at least FEWEST times: from the first to behind the last."""
    return [(first, last + 1) for first, last in stands(samples, FEWEST)]


def jumps(steps: Samples) -> bool:
    """Is the first step a jump, beside those that follow?"""
    if steps.size < 2 or np.isnan(steps).all():
        return False
    return bool(steps[0] > max(LEAST, ALONE * np.nanmax(steps[1:], initial=0.0)))


def turns(time: Samples, rate: Samples) -> float:
    """By how much a gyro turns meanwhile [rad]; 0 where that is no more than its bias may be."""
    turned = abs(float(np.nansum((rate[1:] + rate[:-1]) / 2 * np.diff(time))))
    return turned if turned > max(LEAST, MOVES * float(time[-1] - time[0])) else 0.0


def without(segment: Segment, lost: dict[str, NDArray[np.bool_]]) -> Segment:
    """The segment with NaN for what nobody measured."""
    channels = segment.channels()
    left = {name: np.where(mask, np.nan, channels[name]) for name, mask in lost.items()}
    return replace(segment, **left)


def told(segment: Segment, lost: dict[str, NDArray[np.bool_]]) -> str:
    """How many samples are left out, and when; nothing where none is."""
    places = {
        "of the angle": [mask for name, mask in lost.items() if name != GYRO],
        "of the gyro": [mask for name, mask in lost.items() if name == GYRO],
    }
    found = {whose: np.flatnonzero(np.logical_or.reduce(each)) for whose, each in places.items()}
    counts = [f"{each.size} {whose}" for whose, each in found.items() if each.size]
    if not counts:
        return ""
    every = np.concatenate([*found.values()])
    first, last = segment.begins + segment.time[[every.min(), every.max()]]
    return (
        f"samples ({' and '.join(counts)}) between {first:.2f} and {last:.2f} s repeat a value or "
        "are zero while the leg moves on, as where none was measured: they are left out. Leave "
        "such cells empty."
    )
