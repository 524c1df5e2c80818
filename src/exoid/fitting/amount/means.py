"""Means over neighbouring samples, where they come faster than the motion needs."""

from dataclasses import replace

import numpy as np

from exoid.fitting.amount.part import Part, together, with_sensors
from exoid.recordings.conventions.thin import of_means
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.measured.samples import Samples, block_size
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from exoid.recordings.signal.both_sensors.clean import filtered
from exoid.recordings.signal.local_line import interpolated
from exoid.recordings.signal.noise import noise_of
from exoid.recordings.signal.spikes import wild_samples
from exoid.recordings.signal.turns import pace

RADIANS = 0.05  # of an oscillation that a mean may span: it falls short of it by 1e-4
APART, EVEN = 3, 0.5  # means that tell a curvature, and by how much of a step they may be off
WIDEST = 0.01  # s, the same of a leg: ten milliseconds
HALF, GAP = 0.5, 1.5  # of a mean's samples that must be known; times its span that it may last
CHANNELS = ("raw_angle", "raw_angular_velocity", "angle")  # in which spikes are left out
TOLD = 20_000  # samples of a segment that tell its noise


def averaged(parts: list[Part], most: int) -> tuple[list[Part], int]:
    """The parts with means over so many samples that none has more than `most`, as far as the
    motion allows; and over how many, 1 where nothing was done.

    What went through the node's filter stays: the simulation passes it sample by sample.
    """
    if any(filtered(part.segment) for part in parts):
        return parts, 1
    wanted = int(np.ceil(max(part.segment.time.size for part in parts) / most))
    width = min(wanted * min(map(step_of, parts)), *(allowed(part) for part in parts))
    counts = [block_size(step_of(part), width) for part in parts]
    if max(counts) == 1:
        return parts, 1
    quiet = with_sensors(parts, lambda recording: of_less_noise(recording, max(counts)))
    made = [[means(part.segment, count)] for part, count in zip(quiet, counts, strict=True)]
    return together(quiet, made), max(counts)


def step_of(part: Part) -> float:
    return float(np.median(np.diff(part.segment.time)))


def allowed(part: Part) -> float:
    """How long a mean may be [s]."""
    rate = pace(part.segment.time, part.segment.best_angle)
    return min(WIDEST, RADIANS / rate) if rate > 0 else WIDEST


def means(segment: Segment, count: int) -> Segment:
    """Means over `count` samples, spikes left out; NaN where too few are known, or over a gap."""
    if count == 1:
        return segment
    time, blocks = segment.time, segment.time.size // count
    firsts, lasts = (time[at::count][:blocks] for at in (0, count - 1))
    gaps = lasts - firsts > GAP * count * float(np.median(np.diff(time)))
    channels = {name: each for name, each in segment.channels().items() if name != "time"}
    known = {name: without_spikes(name, time, each) for name, each in channels.items()}
    filled = {name: interpolated(time, each) for name, each in known.items()}
    made = of_means(replace(segment, **filled), count)

    def kept(name: str) -> Samples:
        few = np.isnan(known[name][: blocks * count]).reshape(blocks, count).mean(axis=1) > HALF
        return np.where(few | gaps, np.nan, unbent(made.time, getattr(made, name)))

    return replace(made, **{name: kept(name) for name in channels})


def unbent(time: Samples, mean: Samples) -> Samples:
    """The motion in the middle of each mean over w s: f = mean - w^2 f'' / 24.

    The curvature is that of means three apart, whose noise adds a hundredth; none where they are
    not evenly apart.
    """
    if mean.size <= 2 * APART:
        return mean
    before, after = slice(None, -2 * APART), slice(2 * APART, None)
    here = slice(APART, -APART)
    bend = (mean[before] - 2 * mean[here] + mean[after]) / APART**2
    evenly = np.abs(time[after] - time[before] - 2 * APART * np.median(np.diff(time)))
    bend = np.where(evenly < EVEN * np.median(np.diff(time)), bend, 0.0)
    return mean - np.pad(bend, APART, mode="edge") / 24


def without_spikes(name: str, time: Samples, samples: Samples) -> Samples:
    """A spike would hide in its mean."""
    if name not in CHANNELS:
        return samples
    return np.where(wild_samples(name, time, samples), np.nan, samples)


def of_less_noise(recording: Recording, count: int) -> Sensors:
    """The sensors with the noise that is declared of a mean over `count` samples.

    White noise falls with the root of `count`; what was declared beyond the white noise that the
    samples show may be one error of all of them, and stays.
    """
    sensors, segments = recording.sensors, recording.segments

    def less(declared: float | None, *names: str) -> float | None:
        if declared is None:
            return None
        channels = [each.channels() for each in segments]
        name = next((one for one in names if one in channels[0]), None)
        if name is None:
            return declared
        short = [
            {key: one[:TOLD] for key, one in each.items()} for each in channels if name in each
        ]
        found = noise_of([one["time"] for one in short], [one[name] for one in short], None)
        white = min(found.measured or 0.0, declared)
        return float(np.sqrt(declared**2 - white**2 + white**2 / count))

    return replace(
        sensors,
        angle_noise=less(sensors.angle_noise, "raw_angle", "angle"),
        velocity_noise=less(sensors.velocity_noise, "raw_angular_velocity", "angular_velocity"),
        sample_rate=None,
    )
