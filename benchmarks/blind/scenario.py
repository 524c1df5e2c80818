"""Who is recorded, how the leg is moved, and with which sensors: drawn at random."""

from dataclasses import dataclass

import jax
import jax.numpy as jnp
import numpy as np

from exoid.physics.anatomy import Expected, expected_leg, reach
from exoid.physics.leg import GRAVITY, LegParameters
from exoid.physics.parameter import declarations
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.twin.motion import FrequencyReading, Movement
from exoid.twin.sensors import Encoder, Gyroscope, SensorKit

from .motion import perform

LOWEST, HIGHEST = np.radians(-140.0), np.radians(10.0)  # rad, where a knee can be
SWUNG = np.radians(40.0)  # rad, of every movement at least
TRIED = 48  # movements, of which the first that a leg can do are taken
DROPS, CYCLES_MADE = (2, 5), (5, 8)  # fewest and most
LASTING = (5.2, 7.0)  # s, of a drop: one compiled program serves all
PERIODS = (1.6, 2.5)  # s, likewise
PERIOD_STEP = 0.02  # s, so that half of a period meets a sample
PUSHES = {"1/T": (0.25, 0.95), "2/T": (0.25, 0.75)}  # amplitude over the gravity moment
BUILD = (19.0, 31.0)  # kg/m^2
HEIGHTS = (1.52, 1.98)  # m
SCATTER = (0.10, 0.06, 0.03)  # relative, of mass, COM distance and J / (m l) among people
STIFFNESS, DAMPING = (1.0, 4.0), (0.09, 0.7)  # of a relaxed knee, beyond which none is drawn
RELAXED_STIFFNESS = Expected(2.9, 0.6 * 2.9)  # N m/rad
RELAXED_DAMPING = Expected(0.36, 0.6 * 0.36)  # N m s/rad
ANGLE_NOISE, VELOCITY_NOISE = (0.0004, 0.0009), (0.0018, 0.005)  # rad, rad/s
BIAS = np.radians(0.09)  # rad/s, of the gyro at most


@dataclass(frozen=True)
class Scenario:
    """All of a case but what is concealed in it."""

    subject: Subject
    leg: LegParameters
    movements: tuple[Movement, ...]
    reading: FrequencyReading
    kit: SensorKit
    reached: tuple[float, float]  # rad, lowest and highest angle with nothing concealed

    @property
    def active(self) -> bool:
        return self.movements[0].kind == "active"

    @property
    def angle_floor(self) -> float:
        """Noise and quantisation of the encoder together [rad]."""
        return float(np.hypot(self.kit.encoder.noise, self.kit.encoder.step / 12**0.5))

    @property
    def velocity_floor(self) -> float:
        """Noise and quantisation of the gyro together [rad/s]."""
        return float(np.hypot(self.kit.gyroscope.noise, self.kit.gyroscope.step / 12**0.5))

    def protocol(self) -> Protocol:
        """What the user notes of it."""
        if not self.active:
            return Protocol(kind="passive")
        periods = tuple(each.duration for each in self.movements)
        return Protocol("active", periods, self.reading)

    def sensors(self) -> Sensors:
        """What the data sheets say, to three digits."""
        noises = (self.kit.encoder.noise, self.kit.gyroscope.noise)
        counts = float(self.kit.encoder.counts_per_turn)
        return Sensors(counts, *(float(f"{noise:.3g}") for noise in noises))


def draw_scenario(rng: np.random.Generator, *, active: bool) -> Scenario:
    """A leg that can do its movements without anything concealed in it."""
    while True:
        subject = draw_subject(rng)
        leg = draw_leg(rng, subject)
        reading: FrequencyReading = "1/T" if rng.random() < 0.5 else "2/T"
        tried = [draw_movement(rng, leg, reading, active=active) for _ in range(TRIED)]
        motion = perform(leg, tried, reading, step=0.01)
        able = [k for k, angle in enumerate(motion.angle) if possible(angle) and swings(angle)]
        low, high = CYCLES_MADE if active else DROPS
        count = int(rng.integers(low, high + 1))
        if len(able) >= count:
            done = tuple(tried[k] for k in able[:count])
            angles = np.concatenate([motion.angle[k] for k in able[:count]])
            reached = (float(angles.min()), float(angles.max()))
            return Scenario(subject, leg, done, reading, draw_kit(rng), reached)


def possible(angle: np.ndarray) -> bool:
    """Can a knee move like this?"""
    return bool(np.all(np.isfinite(angle)) and angle.min() > LOWEST and angle.max() < HIGHEST)


def swings(angle: np.ndarray) -> bool:
    return bool(np.ptp(angle) > SWUNG)


def draw_subject(rng: np.random.Generator) -> Subject:
    height = rng.uniform(*HEIGHTS)
    mass = rng.uniform(*BUILD) * height**2
    return Subject(kind="leg", body_mass=round(mass, 1), height=round(height, 3))


def draw_leg(rng: np.random.Generator, subject: Subject) -> LegParameters:
    """A leg as anatomy expects it, with its scatter, that a rigid body can be (Eq. 12, 13)."""
    assert subject.body_mass is not None
    assert subject.height is not None
    expected = expected_leg(subject.body_mass, subject.height, table="de_leva")
    mass, distance = expected.mass.value, expected.com_distance.value
    usual = mass, distance, expected.inertia.value / (mass * distance)
    while True:
        mass, distance, pendulum = (
            around(rng, Expected(value, part * value))
            for value, part in zip(usual, SCATTER, strict=True)
        )
        inertia = mass * distance * pendulum
        leg = LegParameters(
            *(jnp.asarray(each) for each in (mass, inertia, distance)),
            damping=jnp.asarray(around(rng, RELAXED_DAMPING, *DAMPING)),
            stiffness=jnp.asarray(around(rng, RELAXED_STIFFNESS, *STIFFNESS)),
        )
        rigid = mass * distance**2 <= inertia <= reach(subject.height) * mass * distance
        if rigid and in_range(leg):
            return leg


def around(
    rng: np.random.Generator, expected: Expected, low: float = -np.inf, high: float = np.inf
) -> float:
    """A normal draw, within two standard deviations and the limits."""
    while True:
        deviation = expected.standard_deviation or 0.0
        value = rng.normal(expected.value, deviation)
        if low <= value <= high and abs(value - expected.value) < 2 * deviation:
            return value


def in_range(leg: LegParameters) -> bool:
    """Is every parameter within the bounds of Eq. 13?"""
    return all(
        declared.lower <= float(getattr(leg, name)) <= declared.upper
        for name, declared in declarations(LegParameters)
    )


def draw_movement(
    rng: np.random.Generator, leg: LegParameters, reading: FrequencyReading, *, active: bool
) -> Movement:
    """A drop down to rest, or one cycle of Eq. 10; no two alike."""
    if not active:
        return Movement(np.radians(rng.uniform(-55.0, -3.0)), round(rng.uniform(*LASTING), 1))
    period = round(rng.uniform(*PERIODS) / PERIOD_STEP) * PERIOD_STEP
    gravity = float(leg.mass * leg.com_distance) * GRAVITY
    amplitude = -rng.uniform(*PUSHES[reading]) * gravity
    return Movement(np.radians(rng.uniform(-5.0, -1.0)), round(period, 2), amplitude)


def draw_kit(rng: np.random.Generator) -> SensorKit:
    """An encoder and a gyro of the exoskeleton."""
    noise = rng.uniform(*VELOCITY_NOISE)
    gyroscope = Gyroscope(
        noise_density=noise / Gyroscope.bandwidth**0.5, bias=rng.uniform(-BIAS, BIAS)
    )
    return SensorKit(Encoder(noise=rng.uniform(*ANGLE_NOISE)), gyroscope)


def readings(scenario: Scenario, angle, velocity, key) -> tuple[np.ndarray, np.ndarray]:
    """What encoder and gyro log of one segment."""
    angle_key, velocity_key = jax.random.split(key)
    kit = scenario.kit
    raw = kit.encoder.measure(jnp.asarray(angle), angle_key)
    rate = kit.gyroscope.measure(jnp.asarray(velocity), velocity_key)
    return np.asarray(raw, float), np.asarray(rate, float)
