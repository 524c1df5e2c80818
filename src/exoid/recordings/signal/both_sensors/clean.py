"""A recording without what only a sensor can have done: single spikes, tones, drift, play."""

import operator
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from exoid.recordings.measured.samples import Samples
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from exoid.recordings.signal.both_sensors.gyro_drift import gyro_drift
from exoid.recordings.signal.both_sensors.play import find_play
from exoid.recordings.signal.both_sensors.shared_motion import moved_alike, swung_alike
from exoid.recordings.signal.noise import Noise, declared_angle_noise, noise_of, swing_of
from exoid.recordings.signal.smoothed import OF_RATE
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
    given, signals = recording, [getattr(each, angle) for each in recording.segments]
    declared = declared_angle_noise(recording.sensors, signals), recording.sensors.velocity_noise
    recording, angle_noise = clean_channel(given, angle, declared[0])
    if velocity is None:
        return Cleaned(recording, angle_noise, None)
    recording, velocity_noise = clean_channel(recording, velocity, declared[1])
    if filtered(recording.segments[0]):
        return Cleaned(recording, angle_noise, velocity_noise)
    if velocity_noise.tone and swings_alike(given, velocity_noise.tone.frequency):
        recording, angle_noise = clean_channel(given, angle, declared[0], hum=False)
        recording, velocity_noise = clean_channel(recording, velocity, declared[1], hum=False)
    angle_noise, velocity_noise = less_motion(recording, (angle_noise, velocity_noise))
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
    recording: Recording, name: str, declared: float | None, *, hum: bool = True
) -> tuple[Recording, Noise]:
    """Without spikes, and without `hum`, unless that is what moves the leg."""
    times = [each.time for each in recording.segments]
    signals = [getattr(each, name) for each in recording.segments]
    if filtered(recording.segments[0]):
        level = noise_of(times, signals, None).level if declared is None else declared
        return recording, Noise(level, declared=declared)
    spikes = [spikes_of(each, name, declared or 0.0) for each in recording.segments]
    kept = [
        np.where(spike, np.nan, signal) if spike.any() else signal
        for spike, signal in zip(spikes, signals, strict=True)
    ]
    if any(map(coarse, times, kept)):  # neighbours see the motion: neither spike nor tone
        found = noise_of(times, signals, declared)
        level = found.level if declared is None else declared
        return recording, replace(found, level=level)
    count = int(sum(each.sum() for each in spikes))
    of_angle = name in ("raw_angle", "angle")
    swing = swing_of(recording.sensors, signals) if of_angle else OF_RATE
    driven = any(each.driven for each in recording.segments)
    noise = noise_of(times, kept, declared, swing=swing, driven=driven)
    white = noise_of(times, kept, declared) if noise.alike_over else noise
    tone = find_tone(times, kept, white.level) if hum else None
    if tone is not None:
        kept = [without_tone(*each, tone) for each in zip(times, kept, strict=True)]
        noise = noise_of(times, kept, declared, swing=swing, driven=driven)
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


def swings_alike(recording: Recording, frequency: float) -> bool:
    """Does a tone [Hz] move the leg, as encoder and gyro show together?"""
    pairs = both_of(recording)
    return bool(pairs) and swung_alike(pairs, frequency)


def less_motion(recording: Recording, noises: tuple[Noise, Noise]) -> tuple[Noise, Noise]:
    """The noises of angle and gyro, without what they share because the leg moves so."""
    pairs = both_of(recording)
    if not pairs or not any(each.alike_over for each in noises):
        return noises
    times, angles, rates = (list(each) for each in zip(*pairs, strict=True))
    white = [
        noise_of(times, signal, each.declared)
        for signal, each in zip((angles, rates), noises, strict=True)
    ]
    sizes = white[0].measured or 0.0, white[1].measured or 0.0

    def own(each: Noise, alone: Noise) -> Noise:
        moved = each.alike_over and moved_alike(pairs, each.alike_over, sizes)
        return replace(alone, spikes=each.spikes, tone=each.tone) if moved else each

    return own(noises[0], white[0]), own(noises[1], white[1])


def both_of(recording: Recording) -> list[tuple[Samples, Samples, Samples]]:
    """Time, encoder and gyro of every segment; none where one has not both."""
    pairs = [
        (each.time, each.raw_angle, each.raw_angular_velocity)
        for each in recording.segments
        if each.raw_angle is not None and each.raw_angular_velocity is not None
    ]
    return pairs if len(pairs) == len(recording.segments) else []


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
    pairs = both_of(recording)
    found = find_play(pairs, noise.level) if pairs else None
    if found is None:
        return recording, noise
    play, lags = found
    angles = [angle - lag for (_, angle, _), lag in zip(pairs, lags, strict=True)]
    return with_channel(recording, "raw_angle", angles), replace(noise, play=play)
