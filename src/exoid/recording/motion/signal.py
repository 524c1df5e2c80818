"""A segment as the search for its movement sees it: angle and gyro, each with its noise."""

from dataclasses import dataclass

import numpy as np

from exoid.recording.condition import interpolated, local_line
from exoid.recording.motion.limits import (
    HAMPEL,
    HAMPEL_TURN,
    QUIET,
    SPEED_ERROR,
    WIDTHS,
)
from exoid.recording.noise import angle_noise, velocity_noise
from exoid.recording.recording import Samples, Segment, Sensors


@dataclass(frozen=True, eq=False)
class Signal:
    """Angle and angular velocity at every sample, NaN where nothing credible was measured."""

    time: Samples  # s
    angle: Samples  # rad
    angle_noise: float  # rad, white, of one sample
    velocity: Samples | None  # rad/s
    velocity_noise: float  # rad/s

    @property
    def step(self) -> float:
        return float(np.median(np.diff(self.time)))


@dataclass(frozen=True, eq=False)
class Speed:
    """A velocity that is smoothed over as long as its noise needs."""

    velocity: Samples  # rad/s
    error: float  # rad/s, standard deviation of one value
    width: float  # s, of the window

    @property
    def still(self) -> float:
        """The speed below which a leg cannot be told from one that is held by a hand [rad/s]."""
        return max(QUIET[0] * self.error, QUIET[1])


def signal_of(segment: Segment, sensors: Sensors) -> Signal:
    """The raw channels, else the filtered ones; single wild samples are left out."""
    angle = segment.angle if segment.raw_angle is None else segment.raw_angle
    velocity = segment.angular_velocity
    if segment.raw_angular_velocity is not None:
        velocity = segment.raw_angular_velocity
    assert angle is not None  # a Segment has one or the other
    noise = angle_noise(sensors, angle)
    gyro_noise = velocity_noise(sensors, velocity)
    return Signal(
        segment.time,
        without_spikes(angle, noise),
        noise,
        None if velocity is None else without_spikes(velocity, gyro_noise),
        gyro_noise,
    )


def without_spikes(samples: Samples, noise: float) -> Samples:
    """NaN for a sample that stands off the median of the five around it.

    A smooth signal is off its median only where it turns, by the bend that its neighbours show.
    """
    known = np.flatnonzero(~np.isnan(samples))
    if known.size < 5:
        return samples
    values = samples[known]
    around = np.stack([np.roll(values, lag) for lag in (-2, -1, 0, 1, 2)])
    median = np.median(around, axis=0)
    bend = np.abs(around[0] - around[1] - around[3] + around[4]) / 6  # of a parabola
    wild = np.abs(values - median) > HAMPEL * noise + HAMPEL_TURN * bend
    wild[:2] = wild[-2:] = False
    clean = samples.copy()
    clean[known[wild]] = np.nan
    return clean


def speed_of(signal: Signal) -> Speed:
    """The gyro's mean, else the slope of the angle, over the shortest window that is clear."""
    found = [windowed(signal, width) for width in WIDTHS]
    clear = [each for each in found if each.error <= SPEED_ERROR]
    return clear[0] if clear else found[-1]


def windowed(signal: Signal, width: float) -> Speed:
    """The velocity over windows of `width` s, and what noise is left in it."""
    count = max(3, round(width / signal.step))
    if signal.velocity is not None:
        mean = local_line(signal.time, signal.velocity, width)[0]
        return Speed(mean, signal.velocity_noise / np.sqrt(count), width)
    slope = local_line(signal.time, interpolated(signal.time, signal.angle), width)[1]
    places = np.arange(count) * signal.step
    return Speed(slope, signal.angle_noise / (np.std(places) * np.sqrt(count)), width)
