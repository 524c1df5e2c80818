"""A recording without what only a sensor can have done: single spikes, tones, drift, play."""

import operator
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from exoid.recordings.recording import Recording, Segment
from exoid.recordings.samples import Samples
from exoid.recordings.signal.both_sensors.gyro_drift import gyro_drift
from exoid.recordings.signal.both_sensors.play import find_play
from exoid.recordings.signal.noise import (
    OF_ANGLE,
    OF_RATE,
    Noise,
    declared_angle_noise,
    noise_of,
)
from exoid.recordings.signal.spikes import spikes_of
from exoid.recordings.signal.tone import find_tone, without_tone
from exoid.recordings.signal.turns import coarse


@dataclass(frozen=True, eq=False)
class Cleaned:
    """A recording as it enters a fit, and the noise of the channels that are fitted."""

    recording: Recording
    angle: Noise  # rad
    velocity: Noise | None  # rad/s; None without a gyro


@lru_cache(maxsize=8)  # every segment of a recording asks for it
def clean(recording: Recording) -> Cleaned:
    """Leave out spikes, take out tones, a gyro's drift and play, in the channels that are fitted.

    What the firmware's filter gave is left as it is: none can be seen in it.
    """
    angle, velocity = fitted_channels(recording)
    signals = [getattr(each, angle) for each in recording.segments]
    declared = declared_angle_noise(recording.sensors, signals)
    recording, angle_noise = clean_channel(recording, angle, declared)
    velocity_noise = None
    if velocity is not None:
        declared = recording.sensors.velocity_noise
        recording, velocity_noise = clean_channel(recording, velocity, declared)
        if not filtered(recording.segments[0]):
            recording, velocity_noise = steady_gyro(recording, angle_noise, velocity_noise)
            recording, angle_noise = without_play(recording, angle_noise)
    return Cleaned(recording, angle_noise, velocity_noise)


def fitted_channels(recording: Recording) -> tuple[str, str | None]:
    """The names of the channels that a fit compares with: raw ones where there are any."""
    first = recording.segments[0]
    raw = first.raw_angle is not None
    angle, velocity = (
        ("raw_angle", "raw_angular_velocity") if raw else ("angle", "angular_velocity")
    )
    return angle, velocity if getattr(first, velocity) is not None else None


def filtered(segment: Segment) -> bool:
    """Did the channels that are fitted go through the firmware's filter?"""
    return segment.raw_angle is None and segment.angular_velocity is not None


def clean_channel(
    recording: Recording, name: str, declared: float | None
) -> tuple[Recording, Noise]:
    times = [each.time for each in recording.segments]
    signals = [getattr(each, name) for each in recording.segments]
    if filtered(recording.segments[0]):
        level = noise_of(times, signals, None).level if declared is None else declared
        return recording, Noise(level, declared=declared)
    if any(map(coarse, times, signals)):  # neighbours see the motion: neither spike nor tone
        found = noise_of(times, signals, declared)
        level = found.level if declared is None else declared
        return recording, replace(found, level=level)
    spikes = [spikes_of(each, name, declared or 0.0) for each in recording.segments]
    kept = [
        np.where(spike, np.nan, signal) if spike.any() else signal
        for spike, signal in zip(spikes, signals, strict=True)
    ]
    count = int(sum(each.sum() for each in spikes))
    swing = OF_ANGLE if name in ("raw_angle", "angle") else OF_RATE
    noise = noise_of(times, kept, declared, swing=swing)
    white = noise_of(times, kept, declared) if noise.alike_over else noise
    tone = find_tone(times, kept, white.level)
    if tone is not None:
        kept = [without_tone(*each, tone) for each in zip(times, kept, strict=True)]
        noise = noise_of(times, kept, declared, swing=swing)
    return with_channel(recording, name, kept), replace(noise, spikes=count, tone=tone)


def with_channel(recording: Recording, name: str, signals: list[Samples]) -> Recording:
    """The recording with these samples; whatever is left as it was stays what it was, for what is
    known of it.
    """
    segments = tuple(
        each if getattr(each, name) is signal else replace(each, **{name: signal})
        for each, signal in zip(recording.segments, signals, strict=True)
    )
    changed = any(map(operator.is_not, segments, recording.segments))
    return replace(recording, segments=segments) if changed else recording


def steady_gyro(recording: Recording, angle: Noise, gyro: Noise) -> tuple[Recording, Noise]:
    """The same with a gyro whose zero stays where it is on average."""
    times = [each.time for each in recording.segments]
    angles = [each.raw_angle for each in recording.segments if each.raw_angle is not None]
    gyros = (each.raw_angular_velocity for each in recording.segments)
    rates = [each for each in gyros if each is not None]
    drifts = gyro_drift(times, angles, rates, (angle.level, gyro.level))
    if drifts is None:
        return recording, gyro
    segments = [
        replace(each, raw_angular_velocity=rate - drift)
        for each, rate, drift in zip(recording.segments, rates, drifts, strict=True)
    ]
    size = float(np.sqrt(np.mean(np.concatenate(drifts) ** 2)))
    return replace(recording, segments=tuple(segments)), replace(gyro, drift=size)


def without_play(recording: Recording, noise: Noise) -> tuple[Recording, Noise]:
    """The same with the angle of a leg that its encoder follows without play."""
    pairs = [
        (each.time, each.raw_angle, each.raw_angular_velocity)
        for each in recording.segments
        if each.raw_angle is not None and each.raw_angular_velocity is not None
    ]
    found = find_play(pairs, noise.level) if len(pairs) == len(recording.segments) else None
    if found is None:
        return recording, noise
    play, lags = found
    angles = [angle - lag for (_, angle, _), lag in zip(pairs, lags, strict=True)]
    return with_channel(recording, "raw_angle", angles), replace(noise, play=play)
