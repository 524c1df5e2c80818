"""People whose legs follow from girths and lengths, and their drops by SciPy: no code of exoid.

A shank is a stack of slices between four girths, a foot half of the box around it; their masses,
centres and inertias are integrated. Girths go with height and body mass index as calves do (36 cm
at 22 kg/m^2 and 1.75 m, 24 cm at six years, 44 cm at 36 kg/m^2), and scatter. Nothing here reads an
anthropometric table.
"""

from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_ivp

GRAVITY = 9.81
DENSITY = 1085.0  # kg/m^3, of a lower leg
SLICES = 400
KINDS = ("adult", "child", "obese", "spastic")
RATE, DURATION = 100.0, 1.5  # Hz, s
ANGLE_NOISE, VELOCITY_NOISE = 8.7e-4, 1.8e-3  # rad, rad/s


@dataclass(frozen=True)
class Person:
    """A body and the truth of its leg."""

    kind: str
    body_mass: float  # kg
    height: float  # m
    mass: float
    inertia: float
    com_distance: float
    damping: float
    stiffness: float


def person(rng: np.random.Generator, kind: str) -> Person:
    """Somebody of this kind."""
    if kind == "child":
        height, index = rng.uniform(1.0, 1.45), rng.normal(16.5, 1.6)
    elif kind == "obese":
        height, index = rng.normal(1.69, 0.09), rng.uniform(31.0, 46.0)
    else:
        height, index = rng.normal(1.72, 0.09), rng.normal(24.0, 2.7)
    mass, distance, inertia = leg(rng, height, index)
    damping, stiffness = knee(rng, kind)
    return Person(
        kind,
        index * height**2,
        height,
        mass,
        inertia,
        distance,
        damping * inertia,
        stiffness * inertia,
    )


def leg(rng: np.random.Generator, height: float, index: float) -> tuple[float, float, float]:
    """m, l and J of shank and foot about the knee."""
    young = np.clip((1.45 - height) / 0.45, 0.0, 1.0)
    length = height * rng.normal(0.247, 0.0075) * (1 - 0.04 * young)
    calf = 0.354 * (height / 1.75) ** 0.6 * (index / 22) ** 0.45 * rng.normal(1.0, 0.035)
    girths = calf * np.array([0.93, 1.0, 0.70, 0.62]) * rng.normal(1.0, 0.025, 4)
    along = np.linspace(0.0, 1.0, SLICES)
    area = np.interp(along, [0.0, 0.3, 0.65, 1.0], girths) ** 2 / (4 * np.pi)
    slices = DENSITY * area * length / SLICES
    foot = height * rng.normal(0.151, 0.004)
    weight = 0.45 * DENSITY * foot * (0.37 * foot) * (0.29 * foot) * rng.normal(1.0, 0.06)
    weight *= (index / 22) ** 0.3
    below, ahead = length + 0.15 * foot, rng.normal(0.21, 0.02) * foot
    mass = slices.sum() + weight
    down = (slices @ (along * length) + weight * below) / mass
    inertia = slices @ ((along * length) ** 2 + area / (4 * np.pi))
    inertia += weight * (below**2 + ahead**2 + (0.25 * foot) ** 2)
    return mass, float(np.hypot(down, weight * ahead / mass)), float(inertia)


def knee(rng: np.random.Generator, kind: str) -> tuple[float, float]:
    """d / J and c / J: relaxed, or spastic."""
    if kind == "spastic":
        return np.exp(rng.uniform(np.log(2.5), np.log(9.0))), rng.uniform(8.0, 40.0)
    return 0.8 * np.exp(rng.normal(0.0, 0.5)), 6.0 * np.exp(rng.normal(0.0, 0.5))


def drop(
    rng: np.random.Generator, one: Person, start: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Time, angle and angular velocity of a release from rest, as an encoder and a gyro see it."""
    time = np.arange(round(DURATION * RATE)) / RATE

    def motion(_, state):
        angle, velocity = state
        torque = -one.mass * one.com_distance * GRAVITY * np.cos(angle)
        torque -= one.stiffness * angle + one.damping * velocity
        return velocity, torque / one.inertia

    solved = solve_ivp(motion, (0.0, time[-1]), (start, 0.0), t_eval=time, rtol=1e-9, atol=1e-10).y
    noise = rng.normal(size=solved.shape) * [[ANGLE_NOISE], [VELOCITY_NOISE]]
    angle, velocity = solved + noise
    return time, angle, velocity
