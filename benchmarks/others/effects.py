"""What Eq. 9 or the sensors' model may lack, with sizes as they occur."""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from .leg import Leg


@dataclass(frozen=True)
class Effect:
    """`torque` are coefficients of `Physics`, `sensor` those of `Reading`; SI."""

    name: str
    torque: dict[str, float] = field(default_factory=dict)
    sensor: dict[str, float] = field(default_factory=dict)

    @property
    def size(self) -> dict[str, float]:
        return self.torque | self.sensor


NOTHING = Effect("none")
Generator = np.random.Generator
Recipe = Callable[[Leg, Generator], dict[str, Any]]


def friction(leg: Leg, rng: Generator):
    return {"friction": leg.weight * rng.uniform(0.01, 0.05)}


def drag(leg: Leg, rng: Generator):
    return {"drag": leg.inertia * rng.uniform(0.05, 0.3)}


def rest_angle(leg: Leg, rng: Generator):
    return {"rest_angle": rng.choice([-1, 1]) * rng.uniform(0.1, 0.6)}


def cubic(leg: Leg, rng: Generator):
    return {"cubic": leg.weight * rng.uniform(0.03, 0.25)}


def stop(leg: Leg, rng: Generator):
    """The edge of a chair or a calf against it, somewhat beyond where the leg hangs."""
    bounce = rng.uniform(0.05, 0.2)  # s
    rate = np.pi / bounce
    return {
        "stop_angle": -rng.uniform(1.65, 1.9),
        "stop_stiffness": leg.inertia * rate**2,
        "stop_damping": leg.inertia * 2 * rng.uniform(0.1, 0.5) * rate,
    }


def reflex(leg: Leg, rng: Generator):
    return {
        "reflex_gain": leg.inertia * rng.uniform(0.5, 4.0),
        "reflex_threshold": rng.uniform(0.5, 2.5),
        "reflex_delay": rng.uniform(0.03, 0.06),
    }


def maxwell(leg: Leg, rng: Generator):
    return {
        "maxwell_stiffness": leg.weight * rng.uniform(0.08, 0.4),
        "maxwell_time": float(np.exp(rng.uniform(np.log(0.08), np.log(1.5)))),
    }


def eccentricity(leg: Leg, rng: Generator):
    size, phase = np.radians(rng.uniform(0.5, 1.5)), rng.uniform(0, 2 * np.pi)
    return {"sine": size * np.cos(phase), "cosine": size * np.sin(phase)}


def gyro_scale(leg: Leg, rng: Generator):
    return {"scale": rng.choice([-1, 1]) * rng.uniform(0.02, 0.13)}


def gyro_bias(leg: Leg, rng: Generator):
    return {"bias": rng.choice([-1, 1]) * rng.uniform(0.01, 0.1)}


def gyro_delay(leg: Leg, rng: Generator):
    return {"delay": rng.uniform(0.002, 0.015)}


TORQUES: dict[str, Recipe] = {
    "coulomb_friction": friction,
    "quadratic_drag": drag,
    "stiffness_rest_angle": rest_angle,
    "cubic_stiffness": cubic,
    "hard_stop": stop,
    "stretch_reflex": reflex,
    "maxwell_element": maxwell,
}
ENCODERS: dict[str, Recipe] = {"encoder_eccentricity": eccentricity}
GYROS: dict[str, Recipe] = {
    "gyro_scale": gyro_scale,
    "gyro_bias": gyro_bias,
    "sensor_skew": gyro_delay,
}
SENSORS_SHARE = 2.0  # of one sensor's error against one torque: not every device can have it


def draw_effect(
    leg: Leg, *, encoder: bool, gyro: bool, rng: Generator, together: int = 1
) -> Effect:
    """Nothing in one of two, else one effect that this device can have, or so many `together`, of
    which one at most is a sensor's.
    """
    if rng.random() < 0.5:
        return NOTHING
    sensors = (ENCODERS if encoder else {}) | (GYROS if gyro else {})
    recipes = TORQUES | sensors
    shares = np.array([SENSORS_SHARE if each in sensors else 1.0 for each in recipes])
    names: list[str] = []
    while len(names) < together:
        name = str(rng.choice(list(recipes), p=shares / shares.sum()))
        if name not in names and not (name in sensors and sensors.keys() & names):
            names.append(name)
    torque, sensor = {}, {}
    for name in names:
        size = {key: float(value) for key, value in recipes[name](leg, rng).items()}
        (sensor if name in sensors else torque).update(size)
    return Effect("+".join(sorted(names)), torque, sensor)
