"""A segment as the search for its movement sees it: angle and gyro, each with its noise."""

from dataclasses import dataclass, replace
from functools import cached_property
from math import sqrt

import numpy as np
from numpy.typing import NDArray

from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.measured.samples import Samples, block_means, block_size, usual_step
from exoid.recordings.measured.segment import Segment
from exoid.recordings.motion.thresholds import QUIET, SPEED_ERROR, WIDTHS
from exoid.recordings.remembered import remembered
from exoid.recordings.signal.local_line import local_line
from exoid.recordings.signal.noise import declared_angle_noise, noise_of, swing_of
from exoid.recordings.signal.spikes import spikes_of


@dataclass(frozen=True, eq=False)
class Signal:
    """Angle and angular velocity at every sample, NaN where nothing credible was measured."""

    time: Samples  # s
    angle: Samples  # rad
    angle_noise: float  # rad, white, of one sample
    velocity: Samples | None  # rad/s
    velocity_noise: float  # rad/s
    alike: "Signal | None" = None  # of the same samples, where more than their noise is remembered

    @property
    def samples(self) -> "Signal":
        """Whose samples these are."""
        return self if self.alike is None else self.alike

    @cached_property
    def step(self) -> float:
        return usual_step(self.time)

    @cached_property
    def angle_step(self) -> float:
        return self.step_of(self.angle)

    @cached_property
    def speed_step(self) -> float:
        """Of the channel that tells the speed."""
        return self.angle_step if self.velocity is None else self.step_of(self.velocity)

    def step_of(self, samples: Samples) -> float:
        """The usual time between known samples [s]: the other sensor may be faster."""
        known = self.time[~np.isnan(samples)]
        return usual_step(known) if known.size > 1 else self.step

    def part(self, inside: NDArray[np.bool_]) -> "Signal":
        """The samples that are `inside`."""
        velocity = None if self.velocity is None else self.velocity[inside]
        return replace(self, time=self.time[inside], angle=self.angle[inside], velocity=velocity)

    def averaged(self, step: float) -> "Signal":
        """Means over as many samples as fit into `step` s, where that is more than one."""
        count = block_size(self.step, step)
        block = count * self.step
        fewer, less = (np.sqrt(max(block / each, 1)) for each in (self.angle_step, self.speed_step))
        return Signal(
            block_means(self.time, count),
            block_means(self.angle, count),
            self.angle_noise / fewer,
            None if self.velocity is None else block_means(self.velocity, count),
            self.velocity_noise / less,
        )

    def count(self, width: float) -> int:
        """The samples that tell the speed in `width` s; three carry a line and a check."""
        return in_window(width, self.speed_step)

    def spread(self, width: float) -> float:
        """The standard deviation of their times [s]."""
        return self.speed_step * sqrt((self.count(width) ** 2 - 1) / 12)


def in_window(width: float, step: float) -> int:
    """How many samples, `step` s apart, are in a window of `width` s, taken as three at least."""
    return max(3, round(width / step))


@dataclass(frozen=True, eq=False)
class Speed:
    """A velocity that is smoothed over as long as its noise needs."""

    velocity: Samples  # rad/s
    still: float  # rad/s, below which a leg cannot be told from one that is held by a hand
    width: float  # s, of the window


@remembered  # asked again by whoever reads the same segment
def signal_of(segment: Segment, sensors: Sensors) -> Signal:
    """The raw channels, else the filtered ones; single wild samples are left out."""
    raw = segment.raw_angular_velocity is not None
    rate = "raw_angular_velocity" if raw else "angular_velocity"
    declared = declared_angle_noise(sensors, [segment.best_angle])
    of_angle = "angle" if segment.raw_angle is None else "raw_angle"
    swing = swing_of(sensors, [getattr(segment, of_angle)])
    angle, noise = credible(segment, of_angle, declared, swing=swing)
    if getattr(segment, rate) is None:
        return Signal(segment.time, angle, noise, None, np.inf)
    velocity, scatter = credible(segment, rate, sensors.velocity_noise, swing=None)
    return Signal(
        segment.time, angle, noise, velocity - bias(segment.time, angle, velocity), scatter
    )


def bias(time: Samples, angle: Samples, velocity: Samples) -> float:
    """Of a gyro, beside the slope of the angle [rad/s]: it is no movement."""
    slope = local_line(time, angle, max(WIDTHS))[1]
    return float(np.nanmedian(velocity - slope))


def credible(
    segment: Segment, channel: str, declared: float | None, *, swing: float | None
) -> tuple[Samples, float]:
    """The samples without spikes, and their noise."""
    samples, spikes = getattr(segment, channel), spikes_of(segment, channel, declared or 0.0)
    kept = np.where(spikes, np.nan, samples) if spikes.any() else samples
    noise = noise_of([segment.time], [kept], declared, swing=swing, driven=segment.driven)
    return kept, noise.level


@remembered  # every step of the search asks for it
def speed_of(signal: Signal) -> Speed:
    """The gyro's mean, else the slope of the angle, over the shortest window that is clear."""
    *shorter, longest = WIDTHS
    each = ((speed_error(signal, width), width) for width in shorter)
    clear = next((one for one in each if one[0] <= SPEED_ERROR), None)
    error, width = (speed_error(signal, longest), longest) if clear is None else clear
    return speed_over(signal.samples, width, max(QUIET[0] * error, QUIET[1]))


def speed_error(signal: Signal, width: float) -> float:
    """The noise that is left in a velocity over windows of `width` s [rad/s]."""
    root = sqrt(signal.count(width))
    if signal.velocity is not None:
        return signal.velocity_noise / root
    return signal.angle_noise / (signal.spread(width) * root)


@remembered
def speed_over(signal: Signal, width: float, still: float) -> Speed:
    return Speed(velocity_over(signal, width), still, width)


@remembered  # the same where the noise of the same samples is another
def velocity_over(signal: Signal, width: float) -> Samples:
    """The velocity over windows of `width` s.

    Half a window at either end has the value of the first whole one: shorter windows are noisier.
    """
    time = signal.time
    if signal.velocity is not None:
        found = local_line(time, signal.velocity, width)[0]
    else:
        found = lines(signal, width)[1].copy()
    first = int(time.searchsorted(time[0] + width / 2))
    last = int(time.searchsorted(time[-1] - width / 2, side="right"))
    if first < last:
        found[:first], found[last:] = found[first], found[last - 1]
    return found


def smoothed(signal: Signal, width: float) -> tuple[Samples, float]:
    """The angle over windows of `width` s, and its error."""
    return lines(signal, width)[0], signal.angle_noise / sqrt(in_window(width, signal.angle_step))


def lines(signal: Signal, width: float) -> tuple[Samples, Samples]:
    """Value and slope of the angle over windows of `width` s."""
    return lines_of(signal.samples, width)


@remembered  # of most widths twice
def lines_of(signal: Signal, width: float) -> tuple[Samples, Samples]:
    return local_line(signal.time, signal.angle, width)


def bends(signal: Signal, width: float) -> tuple[Samples, Samples]:
    """Slope of the angle and of that slope, as of a parabola over `width` s."""
    return bends_of(signal.samples, width)


@remembered
def bends_of(signal: Signal, width: float) -> tuple[Samples, Samples]:
    return local_line(signal.time, lines_of(signal, width / 2)[1], width / 2)
