"""A recording by an exoskeleton on which nothing is quite as declared."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from benchmarks.pendulum import Leg, still, swing

from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording

RATE = 100.0  # Hz

# One standard deviation, as the README says of what is not declared.
ZERO = np.radians(1.2)
TILT = np.radians(0.2)
GYRO_SCALE = 0.015
GYRO_BIAS = np.radians(5.0)  # rad/s
CLOCK = 1e-4
WEIGHED = 5e-3
PLACED = 5e-3  # m
GYRATION = 0.05  # m

# The clock is declared: else an unusual gyro's scale is also held for a clock's (seldom.py).
EXOSKELETON = Sensors(angle_noise=8.7e-4, velocity_noise=1.8e-3, clock_uncertainty=CLOCK)
CAMERA = Sensors(angle_noise=np.radians(0.3), clock_uncertainty=CLOCK)


@dataclass(frozen=True)
class Act:
    """One movement, as it is declared."""

    start: float  # rad
    duration: float  # s
    added: float = 0.0  # kg
    distance: float = 0.0  # m
    thigh: float = 0.0  # rad
    effort: float | None = None  # N m, of a voluntary cycle of this duration


@dataclass(frozen=True)
class Mistakes:
    """By how much a recording differs from what is declared."""

    zero: float
    tilt: float
    gyro_scale: float
    gyro_bias: float
    clock: float
    weight: float
    distance: float
    gyration: float


def mistakes(rng: np.random.Generator) -> Mistakes:
    sizes = (ZERO, TILT, GYRO_SCALE, GYRO_BIAS, CLOCK, WEIGHED, PLACED)
    return Mistakes(*(float(rng.normal(0, size)) for size in sizes), abs(rng.normal(0, GYRATION)))


def recorded(
    leg: Leg, acts: Sequence[Act], subject: Subject, sensors: Sensors, rng: np.random.Generator
) -> Recording:
    """All movements in one recording, each from its release on."""
    off = mistakes(rng)
    segments = tuple(shown(leg, act, off, sensors, rng) for act in acts)
    loads = tuple(act.added for act in acts)
    protocol = Protocol(
        kind=tuple("passive" if act.effort is None else "active" for act in acts),
        cycle_period=tuple(np.nan if act.effort is None else act.duration for act in acts),
        torque_frequency="1/T",
        thigh_angle=tuple(act.thigh for act in acts),
    )
    distance = max(act.distance for act in acts)
    loaded = {"added_mass": loads, "added_mass_distance": distance} if distance else {}
    person = Subject("leg", body_mass=subject.body_mass, height=subject.height, **loaded)
    return Recording(segments, person, protocol, sensors)


def shown(leg: Leg, act: Act, off: Mistakes, sensors: Sensors, rng: np.random.Generator) -> Segment:
    """One movement as sensors see it."""
    if act.added:
        added = act.added * np.exp(off.weight)
        leg = leg.loaded(added, act.distance + off.distance, off.gyration)
    time = np.arange(0.0, act.duration, 1 / RATE)
    true, torque = time * (1 + off.clock), still if act.effort is None else cycle(act)
    angle, velocity = swing(leg, act.start, true, tilt=act.thigh + off.tilt, torque=torque)
    angle = angle + off.zero + sensors.angle_noise * rng.normal(size=time.size)
    gyro = None
    if sensors.velocity_noise is not None:
        noise = sensors.velocity_noise * rng.normal(size=time.size)
        gyro = (1 + off.gyro_scale) * velocity + off.gyro_bias + noise
    return Segment(time, raw_angle=angle, raw_angular_velocity=gyro)


def cycle(act: Act):
    """Eq. 10 with f = 1/T."""

    def torque(time: float) -> float:
        sine = np.sin(2 * np.pi * time / act.duration)
        return act.effort * (-sine if time <= act.duration / 2 else sine)

    return torque
