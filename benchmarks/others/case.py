"""One case: who, with what, how, and what is wrong; all drawn from the seed and its number."""

from dataclasses import dataclass

import numpy as np

from .devices import DEGREE, Device, Errors, draw_device
from .effects import Effect, draw_effect
from .leg import Physics, physics_of
from .people import Person, draw_person
from .protocol import Protocol, draw_protocol
from .troubles import draw_trouble

SYSTEMATIC = 0.4  # of the cases have errors of zero, seat, gyro scale and clock
ZERO, TILT = 1.0 * DEGREE, 0.3 * DEGREE  # one standard deviation
SCALE, CLOCK = 0.01, 1e-4
BIAS = 5e-4  # rad/s, what is left of a gyro's after it was zeroed


@dataclass(frozen=True)
class Case:
    """Everything that was drawn."""

    name: str
    person: Person
    device: Device
    trouble: str
    effect: Effect
    systematic: bool
    physics: Physics
    errors: Errors
    protocol: Protocol


def name_of_case(seed: int, number: int, together: int) -> str:
    several = f"x{together}" if together > 1 else ""
    return f"s{seed}{several}-{number:04d}"


def source_of(seed: int, number: int, purpose: int) -> np.random.Generator:
    """Randomness of one purpose: 0 what the case is, 1 how it was measured."""
    return np.random.default_rng([seed, number, purpose])


def draw_case(seed: int, number: int, together: int = 1) -> Case:
    """Of this seed; where it lacks anything, so many effects `together`."""
    rng = source_of(seed, number, 0)
    person, device, trouble = draw_person(rng), draw_device(rng), draw_trouble(rng)
    gyro, encoder = device.velocity_noise is not None, device.counts > 0
    effect = draw_effect(person.leg, encoder=encoder, gyro=gyro, rng=rng, together=together)
    systematic = bool(rng.random() < SYSTEMATIC)
    zero, tilt, scale, clock = rng.standard_normal(4) * (ZERO, TILT, SCALE, CLOCK) * systematic
    physics = physics_of(person.leg, **effect.torque)._replace(tilt=float(tilt))
    sensed = {"bias": rng.normal(0, BIAS), "zero": zero, "scale": scale, "clock": clock}
    errors = Errors(**{k: float(v) for k, v in (sensed | effect.sensor).items()})
    protocol = draw_protocol(physics, device.angle_noise, rng)
    name = name_of_case(seed, number, together)
    return Case(name, person, device, trouble, effect, systematic, physics, errors, protocol)
