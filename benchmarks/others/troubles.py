"""What goes wrong while recording, beside white noise."""

from typing import NamedTuple

import numpy as np

from .devices import Device

TROUBLES = ("none", "heavy_tails", "spikes", "hum", "drift", "lost")
SHARES = (0.4, 0.12, 0.12, 0.12, 0.12, 0.12)
LOST = 0.03  # of the samples
FREEDOM = 3  # of Student's t


class Disturbed(NamedTuple):
    """What is added to angle [rad] and rate [rad/s], and which samples are there."""

    angle: np.ndarray
    velocity: np.ndarray
    kept: np.ndarray


def draw_trouble(rng: np.random.Generator) -> str:
    return str(rng.choice(TROUBLES, p=SHARES))


def disturb(trouble: str, device: Device, time: np.ndarray, rng: np.random.Generator) -> Disturbed:
    """Noise of the device's level, and the trouble."""
    gyro = device.velocity_noise or 0.0
    angle, velocity = (
        size * draw_noise(trouble, time.size, rng) for size in (device.angle_noise, gyro)
    )
    kept = np.ones(time.size, bool)
    if trouble == "spikes":
        angle += device.angle_noise * draw_spikes(time.size, rng)
        velocity += gyro * draw_spikes(time.size, rng)
    elif trouble == "hum":
        wave = draw_hum(time, rng)
        angle += device.angle_noise * wave
        velocity += gyro * wave
    elif trouble == "drift":
        angle_drift, rate_drift = draw_drift(device, rng)
        course = draw_course(time, rng)
        angle += angle_drift * course
        velocity += rate_drift * course
    elif trouble == "lost":
        kept = rng.random(time.size) >= LOST
    return Disturbed(angle, velocity, kept)


def draw_noise(trouble: str, size: int, rng: np.random.Generator) -> np.ndarray:
    """Of unit variance: normal, or with tails of Student's t."""
    if trouble != "heavy_tails":
        return rng.standard_normal(size)
    return rng.standard_t(FREEDOM, size) / (FREEDOM / (FREEDOM - 2)) ** 0.5


def draw_spikes(size: int, rng: np.random.Generator) -> np.ndarray:
    """Single samples of 10 to 100 noise levels; 1 to 5 in a thousand."""
    where = rng.random(size) < rng.uniform(0.001, 0.005)
    height = np.exp(rng.uniform(np.log(10), np.log(100), size)) * rng.choice([-1, 1], size)
    return where * height


def draw_hum(time: np.ndarray, rng: np.random.Generator) -> np.ndarray:
    """The mains, as the samples see it: folded to a low frequency, or to half the rate."""
    mains = rng.choice([50.0, 60.0]) * (1 + rng.normal(0, 2e-4))
    return rng.uniform(0.5, 2.0) * 2**0.5 * np.sin(2 * np.pi * (mains * time + rng.random()))


def draw_drift(device: Device, rng: np.random.Generator) -> tuple[float, float]:
    """Sizes in rad and rad/s: a gyro's bias drifts where there is one, else the angle does."""
    if device.velocity_noise is not None:
        return 0.0, float(rng.uniform(0.005, 0.03))
    return float(rng.uniform(0.5, 1.5) * device.angle_noise), 0.0


def draw_course(time: np.ndarray, rng: np.random.Generator) -> np.ndarray:
    """Slowly from 0 to about 1, or there and back."""
    share = (time - time[0]) / max(time[-1] - time[0], 1e-9)
    return share if rng.random() < 0.5 else np.sin(2 * np.pi * share * rng.uniform(0.3, 1.5))
