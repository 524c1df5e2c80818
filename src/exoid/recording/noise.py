"""The white noise of a sampled signal: declared by its sensor, else from the samples themselves."""

import numpy as np

from exoid.recording.recording import Samples, Sensors


def angle_noise(sensors: Sensors, angle: Samples) -> float:
    """Standard deviation [rad] of an angle sample, with what the encoder's steps add."""
    step = 0.0 if sensors.encoder_counts is None else 2 * np.pi / sensors.encoder_counts
    white = scatter(angle) if sensors.angle_noise is None else sensors.angle_noise
    return float(np.hypot(white, step / np.sqrt(12)))


def velocity_noise(sensors: Sensors, velocity: Samples | None) -> float:
    """Standard deviation [rad/s] of a gyro sample: declared, else from the data."""
    if velocity is None:
        return np.inf
    return scatter(velocity) if sensors.velocity_noise is None else sensors.velocity_noise


def scatter(samples: Samples) -> float:
    """White noise of a smooth signal, from its third differences (whose variance is 20 times)."""
    third = np.diff(samples[~np.isnan(samples)], 3)
    spread = float(np.median(np.abs(third)) / 0.6745 / np.sqrt(20))
    return spread if spread > 0 else float(np.std(third) / np.sqrt(20)) or 1e-6
