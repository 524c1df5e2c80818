"""Motions of a knee as the sensors see them, made from a seed."""

import numpy as np
from float32_node import ENCODER_STEP, GYRO_STEP


def measured(samples: int, seed: int = 0) -> tuple[np.ndarray, np.ndarray]:
    """Encoder [rad] and gyro [rad/s] of swings whose rhythm wanders, quantised, in float32."""
    rng = np.random.default_rng(seed)
    phase = np.cumsum(2 * np.pi * 0.01 * (1 + 0.5 * np.sin(np.arange(samples) * 0.003)))
    size = 0.7 * np.sin(np.arange(samples) * 0.0007)
    angle = -1.25 + size * np.cos(phase)
    rate = np.gradient(angle, 0.01)
    counts = np.rint((angle + rng.normal(0, 8e-4, samples)) / float(ENCODER_STEP))
    turns = np.rint((rate + rng.normal(0, 2e-3, samples)) / float(GYRO_STEP))
    return counts.astype(np.float32) * ENCODER_STEP, turns.astype(np.float32) * GYRO_STEP


def with_losses(values: np.ndarray, share: float, seed: int) -> np.ndarray:
    """The values with NaN in place of a share of them, at random."""
    lost = np.random.default_rng(seed).random(values.size) < share
    return np.where(lost, np.float32(np.nan), values)
