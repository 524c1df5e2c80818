"""The two recordings and the starts on which every method of the speed benchmark is timed.

Both are simulated from one leg (J phi'' = tau_h - m l g cos phi - c phi - d phi', tau_h of Eq. 10)
with the noise of the real sensors, so the best fit is known to lie near the truth.
"""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

GRAVITY = 9.81  # m/s^2
REACH = 0.55  # m, knee to sole: no rigid leg has J > REACH * m * l
MASS, INERTIA, COM_DISTANCE, DAMPING, STIFFNESS = 4.4, 0.45, 0.273, 0.35, 2.8

# Eq. 13, in the order m [kg], J [kg m^2], l [m], d [N m s/rad], c [N m/rad], tau [N m]
LOWER = np.array([2.0, 0.15, 0.15, 0.0, 0.0, -250.0])
UPPER = np.array([6.0, 1.0, 0.6, 60.0, 4.0, 250.0])

TIME_STEP = 0.01  # s
SUBSTEPS = 5  # of the simulation that makes the data, per sample
ANGLE_NOISE = 0.00086  # rad
VELOCITY_NOISE = 0.0028  # rad/s
ENCODER_COUNTS = 4096


@dataclass(frozen=True, eq=False)
class Segment:
    """One drop or one voluntary cycle, from its release or from the start of its cycle."""

    time: np.ndarray  # s, from 0
    angle: np.ndarray  # rad, with noise
    angular_velocity: np.ndarray  # rad/s, with noise
    period: float  # s, of the cycle; of a drop its duration
    frequency: float  # Hz, of the torque: 1/T in a cycle; 0 in a drop, which makes Eq. 10 zero


Problem = tuple[Segment, ...]


def torque_shape(time, segment: Segment):
    """Eq. 10 at unit amplitude: -sin(2 pi f t) up to T/2, then +sin(2 pi f t)."""
    wave = np.sin(2 * np.pi * segment.frequency * time)
    return np.where(time <= segment.period / 2, -wave, wave)


def cycle() -> Problem:
    """One voluntary cycle of 2 s."""
    return (record(2.0, np.random.default_rng(1), amplitude=-9.5, angle_deg=-3.0),)


def ten_segments() -> Problem:
    """Four drops of 5 s from four angles, then three cycles at each of two paces."""
    rng = np.random.default_rng(2)
    drops = [record(5.0, rng, angle_deg=angle) for angle in (-10.0, -25.0, -40.0, -55.0)]
    slow = [
        record(2.0, rng, amplitude=amplitude, angle_deg=angle)
        for amplitude, angle in ((-8.5, -2.0), (-9.5, -5.0), (-10.5, -8.0))
    ]
    fast = [
        record(1.4, rng, amplitude=amplitude, angle_deg=angle)
        for amplitude, angle in ((-6.5, -2.0), (-7.2, -5.0), (-7.8, -8.0))
    ]
    return (*drops, *slow, *fast)


def starts(n: int, seed: int) -> np.ndarray:
    """`n` parameter vectors (m, J, l, d, c, tau), uniform within the bounds of Eq. 13."""
    return np.random.default_rng(seed).uniform(LOWER, UPPER, size=(n, LOWER.size))


def record(
    duration: float, rng: np.random.Generator, *, angle_deg: float, amplitude: float = 0.0
) -> Segment:
    """What the sensors give of a leg that starts at rest; without amplitude it is a drop."""
    time = TIME_STEP * np.arange(round(duration / TIME_STEP) + 1)
    frequency = 1 / duration if amplitude else 0.0
    clean = Segment(time, np.zeros_like(time), np.zeros_like(time), duration, frequency)
    angle, velocity = swing(clean, np.radians(angle_deg), amplitude)
    count = 2 * np.pi / ENCODER_COUNTS
    angle = count * np.round((angle + ANGLE_NOISE * rng.standard_normal(time.size)) / count)
    velocity = velocity + VELOCITY_NOISE * rng.standard_normal(time.size)
    return Segment(time, angle, velocity, duration, frequency)


def swing(segment: Segment, angle: float, amplitude: float) -> tuple[np.ndarray, np.ndarray]:
    """The true angle and angular velocity at the segment's samples (RK4 at fine steps)."""

    def rate(t, x):
        torque = amplitude * torque_shape(t, segment)
        load = MASS * COM_DISTANCE * GRAVITY * np.cos(x[0]) + STIFFNESS * x[0] + DAMPING * x[1]
        return np.array([x[1], (torque - load) / INERTIA])

    h = TIME_STEP / SUBSTEPS
    states = [np.array([angle, 0.0])]
    for step in range((segment.time.size - 1) * SUBSTEPS):
        t, x = step * h, states[-1]
        k1 = rate(t, x)
        k2 = rate(t + h / 2, x + h / 2 * k1)
        k3 = rate(t + h / 2, x + h / 2 * k2)
        k4 = rate(t + h, x + h * k3)
        states.append(x + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4))
    sampled = np.array(states[::SUBSTEPS])
    return sampled[:, 0], sampled[:, 1]


def write(problem: Problem, path: Path) -> None:
    """Writes `path` (CSV) and its TOML sidecar in recording format version 1."""
    rows = ["time_s,segment,raw_angle_rad,raw_velocity_rad_s"]
    for number, segment in enumerate(problem):
        samples = zip(segment.time, segment.angle, segment.angular_velocity, strict=True)
        rows += [f"{t:.2f},{number},{angle:.8f},{rate:.8f}" for t, angle, rate in samples]
    path.write_text("\n".join(rows) + "\n")
    path.with_suffix(".toml").write_text(sidecar(problem))


def sidecar(problem: Problem) -> str:
    kinds = ["active" if segment.frequency else "passive" for segment in problem]
    periods = [segment.period for segment in problem]  # a drop's entry is there for the count
    return f"""\
[subject]
kind = "leg"
body_mass_kg = 77.0
height_m = 1.8

[protocol]
kind = {kinds}
cycle_period_s = {periods}
torque_frequency = "1/T"
thigh_angle_uncertainty_rad = 0.0

[sensors]
encoder_counts = {ENCODER_COUNTS}
angle_noise_rad = {ANGLE_NOISE}
velocity_noise_rad_s = {VELOCITY_NOISE}
sample_rate_hz = {1 / TIME_STEP:.1f}
angle_zero_uncertainty_rad = 0.0
gyro_scale_uncertainty = 0.0
clock_uncertainty = 0.0
"""
