"""Legs, hands and sensors for the live estimator, by SciPy: nothing of exoid is in here.

A session is held, let go, swings, is caught and lifted again. It is sampled as the node does:
an encoder of 12 bits with a zero of its own, a gyro with a bias whose sample is up to 1.2 ms old.
"""

from dataclasses import dataclass, replace
from math import cos, tanh

import numpy as np
from scipy.integrate import odeint

DEGREE = np.pi / 180
COUNT, RATE_STEP = 2 * np.pi / 4096, 0.07 * DEGREE  # rad, rad/s: what encoder and gyro tell apart
ENCODER_NOISE = 0.043 * DEGREE  # rad, AS5600
GYRO_NOISE = 7e-3 * DEGREE * np.sqrt(833 / 2)  # rad/s, LSM6DS3 at 833 Hz
RENEWAL = 1 / 833  # s between the gyro's own samples
SHARP = 2e-3  # rad/s, over which friction turns round


@dataclass(frozen=True)
class Leg:
    """J phi'' = J (-gravity cos(phi + tilt) - stiffness phi - damping phi' - friction sgn phi')."""

    gravity: float  # 1/s^2
    stiffness: float  # 1/s^2
    damping: float  # 1/s
    friction: float = 0.0  # 1/s^2
    inertia: float = 0.42  # kg m^2
    tilt: float = 0.0  # rad, of the seat

    def heavier(self, share: float) -> "Leg":
        """With mass and inertia larger by a share, at the same place: knee and friction stay."""
        own = 1 + share
        return replace(
            self,
            stiffness=self.stiffness / own,
            damping=self.damping / own,
            friction=self.friction / own,
            inertia=self.inertia * own,
        )

    def loaded(self, mass: float, distance: float) -> "Leg":
        """With a mass [kg] at a distance [m] from the knee."""
        total = self.inertia + mass * distance**2
        share = self.inertia / total
        return Leg(
            share * self.gravity + mass * distance * 9.81 / total,
            share * self.stiffness,
            share * self.damping,
            share * self.friction,
            total,
            self.tilt,
        )


@dataclass(frozen=True)
class Sensors:
    """What is wrong with them, and with the seat."""

    zero: float  # rad, of the encoder
    bias: float  # rad/s, of the gyro
    scale: float  # relative, of the gyro
    tilt: float  # rad, of the seat


def draw_leg(rng: np.random.Generator, friction: float = 0.0) -> Leg:
    """Of an adult: m l g / J scatters by 3.5 %, J by 12 %, the knee by a factor of 1.8."""
    gravity, stiffness, damping, inertia = np.exp(rng.standard_normal(4) * [0.035, 0.6, 0.6, 0.12])
    rubbing = friction * abs(rng.standard_normal())
    return Leg(26.5 * gravity, 6.6 * stiffness, 0.8 * damping, rubbing, 0.43 * inertia)


def draw_sensors(rng: np.random.Generator) -> Sensors:
    """A zero off by 3 degrees, a bias of 5 deg/s; gyro and seat by their data sheet and a level."""
    zero, bias, scale, tilt = rng.standard_normal(4)
    return Sensors(3 * DEGREE * zero, 5 * DEGREE * bias, 0.015 * scale, 0.2 * DEGREE * tilt)


def draw_slant(rng: np.random.Generator) -> float:
    """By how much a foot puts the centre of mass beside the leg's line [rad]: of every other leg,
    by 2.5 degrees.
    """
    return 2.5 * DEGREE * rng.standard_normal() if rng.random() < 0.5 else 0.0


def swing(leg: Leg, start: float, time: np.ndarray, letting_go: float) -> np.ndarray:
    """Angle, rate and acceleration after a hand lets go within so many seconds."""

    def rate(state, at):
        angle, speed = state
        pull = -leg.gravity * cos(angle + leg.tilt) - leg.stiffness * angle - leg.damping * speed
        if leg.friction:
            pull -= leg.friction * tanh(speed / SHARP)
        return speed, pull * min(at / letting_go, 1.0) if letting_go > 0 else pull

    steps = {"rtol": 1e-9, "atol": 1e-10, "hmax": 0.02, "mxstep": 5000}
    found = odeint(rate, (start, 0.0), time, **steps)
    turned = [rate(state, at)[1] for at, state in zip(time.tolist(), found.tolist(), strict=True)]
    return np.stack([*found.T, turned])


def session(
    rng: np.random.Generator, legs: list[Leg], *, seconds: float = 4.0, tick: float = 0.01
) -> tuple[np.ndarray, list[tuple[float, float]]]:
    """Angle, rate and acceleration of drops one after the other, one of each leg, and between
    which times [s] each was free.
    """
    parts, free, clock, last = [], [], 0.0, -70 * DEGREE
    for leg in legs:
        start = rng.uniform(-30, 10) * DEGREE
        held = lift(last, start, rng.uniform(1.0, 2.0), tick), rest(rng, start, tick)
        begun = clock + tick * sum(part.shape[1] for part in held)
        time = np.arange(round(seconds / tick)) * tick
        moved = swing(leg, held[1][0, -1], time, rng.uniform(0.0, 0.06))
        after = catch(moved[:, -1], rng.uniform(0.03, 0.06), tick)
        last = after[0, -1]
        parts += [*held, moved, after]
        free.append((begun, begun + seconds))
        clock = begun + tick * (moved.shape[1] + after.shape[1])
    return np.concatenate(parts, axis=1), free


def lift(one: float, other: float, seconds: float, tick: float) -> np.ndarray:
    """A hand brings the leg from one angle to another."""
    turn, half = np.pi / seconds, (other - one) / 2
    phase = turn * np.arange(0.0, seconds, tick)
    return np.stack(
        [
            one + half * (1 - np.cos(phase)),
            half * turn * np.sin(phase),
            half * turn**2 * np.cos(phase),
        ]
    )


def rest(rng: np.random.Generator, angle: float, tick: float) -> np.ndarray:
    """A hand that trembles holds it, and is still when it lets go."""
    time = np.arange(0.0, rng.uniform(1.0, 2.0), tick)
    size, rate = rng.uniform(0.0, 0.15) * DEGREE, 2 * np.pi * rng.uniform(3.0, 8.0)
    fading = np.clip((time[-1] - time) / 0.2, 0.0, 1.0)
    shake = size * fading * np.sin(rate * time)
    return np.stack(
        [angle + shake, np.gradient(shake, tick), np.gradient(np.gradient(shake, tick), tick)]
    )


def catch(state: np.ndarray, within: float, tick: float) -> np.ndarray:
    """A hand stops the leg and holds it for a second."""
    time = np.arange(1, round(1.2 / tick)) * tick
    left = np.exp(-time / within)
    angle, speed = state[0], state[1]
    return np.stack([angle + within * speed * (1 - left), speed * left, -speed / within * left])


def measured(
    rng: np.random.Generator, motion: np.ndarray, sensors: Sensors, tick: float = 0.01
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Time, angle and rate as the node logs them."""
    angle, rate, acceleration = motion
    time = np.arange(angle.size) * tick
    scatter = rng.standard_normal((2, angle.size))
    period = RENEWAL * (1 + 0.03 * rng.uniform(-1, 1))
    age = (rng.uniform() * period + time) % period
    shown = angle + sensors.zero + ENCODER_NOISE * scatter[0]
    turned = (1 + sensors.scale) * (rate - age * acceleration) + sensors.bias
    turned = turned + GYRO_NOISE * scatter[1]
    return time, COUNT * np.round(shown / COUNT), RATE_STEP * np.round(turned / RATE_STEP)
