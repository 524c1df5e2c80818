"""What people record with: the node, another maker's encoder and gyro, cameras, angles of IMUs."""

from dataclasses import dataclass

import numpy as np

DEGREE = np.pi / 180
GYRO_STEP = 70e-3 * DEGREE  # rad/s per count at 2000 deg/s, LSM6DS3
KINDS = ("node", "encoder_gyro", "camera", "imu_angle")
CAMERAS = (30, 50, 60, 100, 120, 240)  # Hz
LOGGERS = (50, 100, 125, 200, 250, 400)  # Hz


@dataclass(frozen=True)
class Device:
    """A device with its noise; `velocity_noise` is None where there is no gyro."""

    kind: str
    rate: float  # Hz
    angle_noise: float  # rad, white, one standard deviation
    velocity_noise: float | None  # rad/s
    counts: int  # of a turn; 0: angles come as numbers with their own digits
    jitter: float  # s, of the instants, which the time column tells
    declared: bool  # the noise stands in the sidecar

    @property
    def whole_angle_noise(self) -> float:
        """rad, rounding to counts included (a count over the root of 12)."""
        count = 2 * np.pi / self.counts if self.counts else 0.0
        return float(np.hypot(self.angle_noise, count / 12**0.5))

    @property
    def whole_velocity_noise(self) -> float | None:
        step = GYRO_STEP / 12**0.5
        return None if self.velocity_noise is None else float(np.hypot(self.velocity_noise, step))


@dataclass(frozen=True)
class Errors:
    """Of the sensors: the encoder shows phi + zero + sine sin(phi) + cosine cos(phi) at `clock`."""

    zero: float = 0.0  # rad
    sine: float = 0.0  # rad
    cosine: float = 0.0  # rad
    scale: float = 0.0  # of the gyro
    bias: float = 0.0  # rad/s
    delay: float = 0.0  # s, of the gyro
    clock: float = 0.0  # the time column runs fast by this share

    def angle(self, true: np.ndarray) -> np.ndarray:
        return true + self.zero + self.sine * np.sin(true) + self.cosine * np.cos(true)

    def velocity(self, true: np.ndarray) -> np.ndarray:
        """`true` is the rate of `delay` ago."""
        return (1 + self.scale) * true + self.bias


def draw_device(rng: np.random.Generator) -> Device:
    kind = str(rng.choice(KINDS))
    declared, jitter = bool(rng.random() < 0.5), 0.0
    if kind == "node":
        noise, gyro = rng.uniform(0.02, 0.05) * DEGREE, rng.uniform(0.005, 0.010)
        return Device(kind, 100.0, noise, gyro, 4096, jitter, declared)
    if rng.random() < 0.3:
        jitter = 10 ** rng.uniform(-4.0, -3.0)
    if kind == "encoder_gyro":
        noise, gyro = 10 ** rng.uniform(-2, -1) * DEGREE, 10 ** rng.uniform(-2.7, -1.7)
        counts = int(rng.choice([4096, 8192, 16384, 0]))
        return Device(kind, float(rng.choice(LOGGERS)), noise, gyro, counts, jitter, declared)
    if kind == "camera":
        noise = 10 ** rng.uniform(-1, 0) * DEGREE
        return Device(kind, float(rng.choice(CAMERAS)), noise, None, 0, jitter, declared)
    noise = rng.uniform(0.1, 0.5) * DEGREE
    gyro = 10 ** rng.uniform(-2.3, -1.7) if rng.random() < 0.3 else None
    return Device(kind, float(rng.choice([50, 60, 100, 200])), noise, gyro, 0, jitter, declared)


def sample_times(device: Device, begin: float, end: float, rng: np.random.Generator):
    """s, evenly from a random phase, with jitter that never turns the order."""
    step = 1 / device.rate
    even = np.arange(begin + rng.uniform(0, step), end, step)
    shaken = np.clip(rng.normal(0, device.jitter, even.size), -0.4 * step, 0.4 * step)
    return np.clip(even + shaken, begin, end)


def rounded(values: np.ndarray, step: float) -> np.ndarray:
    return step * np.round(values / step) if step else values
