"""Simulated drops of many people, in a few milliseconds each: a pendulum by Runge-Kutta in NumPy.

Masses, inertias and lengths follow anatomy with the scatter of its tables; damping and stiffness
those of relaxed knees. All legs of a call swing at once.
"""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from exoid.physics.anatomy import expected_leg

GRAVITY = 9.81  # m/s^2
STEP, FINER = 0.01, 4  # s between samples, and steps of the simulation in each
HELD, SECONDS = 1.0, 6.0  # s before the release, and after it
NOISE = 7.5e-4, 1.8e-3  # rad, rad/s: the sensors'
COUNT = 2 * np.pi / 4096  # rad, of the encoder
SCATTER = {"mass": 0.1, "inertia": 0.07, "com_distance": 0.05, "damping": 0.3, "stiffness": 0.3}
SIDECAR = """\
[subject]
kind = "leg"
body_mass_kg = {mass:.1f}
height_m = {height:.3f}

[protocol]
kind = "passive"

[sensors]
encoder_counts = 4096
angle_noise_rad = 7.5e-4
velocity_noise_rad_s = 1.8e-3
sample_rate_hz = 100.0
"""


@dataclass(frozen=True, eq=False)
class Drops:
    """One drop each of many legs."""

    time: np.ndarray  # s
    angle: np.ndarray  # rad, (leg, sample)
    velocity: np.ndarray  # rad/s
    mass: np.ndarray  # kg, of the body
    height: np.ndarray  # m


def drops(count: int, seed: int = 0) -> Drops:
    """What the sensors give of so many legs."""
    generator = np.random.default_rng(seed)
    mass, height = generator.uniform(50, 95, count), generator.uniform(1.55, 1.95, count)
    legs = [expected_leg(*each) for each in zip(mass.tolist(), height.tolist(), strict=True)]
    own = {
        name: np.array([float(getattr(leg, name).value) for leg in legs])
        * np.exp(share * generator.normal(size=count))
        for name, share in SCATTER.items()
    }
    angle, velocity = swing(own, np.radians(generator.uniform(-25, -5, count)))
    held = np.repeat(angle[:, :1], round(HELD / STEP), axis=1)
    angle = np.concatenate([held, angle], axis=1)
    velocity = np.concatenate([np.zeros_like(held), velocity], axis=1)
    noisy = angle + NOISE[0] * generator.normal(size=angle.shape)
    rate = velocity + NOISE[1] * generator.normal(size=angle.shape)
    time = STEP * np.arange(angle.shape[1])
    return Drops(time, COUNT * np.round(noisy / COUNT), rate, mass, height)


def swing(own: dict[str, np.ndarray], start: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Angle and angular velocity from the release on, (leg, sample)."""
    gravity = own["mass"] * own["com_distance"] * GRAVITY

    def rate(state: np.ndarray) -> np.ndarray:
        angle, velocity = state
        load = gravity * np.cos(angle) + own["stiffness"] * angle + own["damping"] * velocity
        return np.stack([velocity, -load / own["inertia"]])

    state, step = np.stack([start, np.zeros_like(start)]), STEP / FINER
    states = [state]
    for _ in range(round(SECONDS / STEP) * FINER):
        first = rate(state)
        second = rate(state + step / 2 * first)
        third = rate(state + step / 2 * second)
        fourth = rate(state + step * third)
        state = state + step / 6 * (first + 2 * second + 2 * third + fourth)
        states.append(state)
    angle, velocity = np.stack(states[::FINER], axis=2)
    return angle, velocity


def write(made: Drops, folder: Path) -> None:
    """A data set: a table and a sidecar of every leg."""
    folder.mkdir(parents=True, exist_ok=True)
    for number, (angle, rate) in enumerate(zip(made.angle, made.velocity, strict=True)):
        rows = np.stack([made.time, angle, rate], axis=1)
        path = folder / f"P{number // 2:05d}_{'left' if number % 2 else 'right'}.csv"
        lines = [f"{t:.2f},{a:.8f},{v:.8f}" for t, a, v in rows]
        path.write_text("\n".join(["time_s,raw_angle_rad,raw_velocity_rad_s", *lines, ""]))
        told = SIDECAR.format(mass=made.mass[number], height=made.height[number])
        path.with_suffix(".toml").write_text(told)
