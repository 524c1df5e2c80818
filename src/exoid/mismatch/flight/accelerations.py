"""Accelerations between strikes: of a frame within its play, and of all that moves as one.

Around a turn a frame with play leaves the leg and swings by itself until it strikes it again.
Shortly before a strike the gyro therefore shows the frame's own law of motion, at other times that
of both as one.
"""

from dataclasses import dataclass

import numpy as np

from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.mismatch.sensors.strikes import times_of_strikes

FLIGHT = 0.05  # s before a strike, in which a frame surely swings by itself
DEPARTED = 0.2  # s before one, in which it may
BOUNCES = 0.08  # s behind one, until both move as one again
MOVING = 0.3  # rad/s, below which friction may hold


@dataclass(frozen=True, eq=False)
class Accelerations:
    """What the gyro shows from each sample to the next: (segment, step)."""

    angle: np.ndarray  # rad
    angular_velocity: np.ndarray  # rad/s
    value: np.ndarray  # rad/s^2
    flying: np.ndarray  # does a strike follow shortly
    joined: np.ndarray  # is none near


def strikes_of(prepared: PreparedRecording) -> list[np.ndarray]:
    """When [s] something strikes in every segment, by the gyro alone."""
    seen = prepared.seen
    each = map(np.asarray, (seen.time, seen.angular_velocity, seen.velocity_weight))
    return [times_of_strikes(*rows) for rows in zip(*each, strict=True)]


def accelerations(prepared: PreparedRecording) -> Accelerations:
    """Between the samples of all segments, while something moves."""
    seen = prepared.seen
    time, rate, weight = map(np.asarray, (seen.time, seen.angular_velocity, seen.velocity_weight))
    speed, step = halfway(rate), np.diff(time)
    counts = (weight[:, 1:] > 0) & (weight[:, :-1] > 0) & (np.abs(speed) > MOVING)
    flying, joined = np.zeros_like(counts), np.zeros_like(counts)
    for row, struck in enumerate(strikes_of(prepared)):
        ago = halfway(time[row]) - struck[:, None]
        own = (ago > -FLIGHT) & (ago < -1.5 * step[row])  # the step before may be struck, too
        flying[row] = counts[row] & own.any(axis=0)
        joined[row] = counts[row] & ((ago < -DEPARTED) | (ago > BOUNCES)).all(axis=0)
    value = np.diff(rate) / np.where(counts, step, 1.0)
    return Accelerations(halfway(prepared.measured_motion.angle), speed, value, flying, joined)


def halfway(values: np.ndarray) -> np.ndarray:
    """Between the samples."""
    return (values[..., 1:] + values[..., :-1]) / 2
