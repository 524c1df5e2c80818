"""People, and the exoskeleton on whose frame they sit: drawn, by nothing of exoid."""

from dataclasses import dataclass, replace

import numpy as np
from benchmarks.people import person

GRAVITY = 9.81  # m/s^2


@dataclass(frozen=True)
class Leg:
    """Shank and foot about the knee: J phi'' = tau - m l g cos(phi) - c phi - d phi'."""

    mass: float  # kg
    distance: float  # m, from the knee to the centre of mass
    inertia: float  # kg m^2, about the knee
    stiffness: float  # N m/rad
    damping: float  # N m s/rad

    @property
    def weight(self) -> float:
        """m l g [N m]."""
        return self.mass * self.distance * GRAVITY

    def heavier(self, share: float) -> "Leg":
        """With mass and inertia larger by a share, at the same place, of a knee as stiff."""
        return replace(self, mass=self.mass * (1 + share), inertia=self.inertia * (1 + share))

    def loaded(self, mass: float, distance: float) -> "Leg":
        """With a weight [kg] strapped on at a distance [m] from the knee."""
        total = self.mass + mass
        centre = (self.mass * self.distance + mass * distance) / total
        return replace(self, mass=total, distance=centre, inertia=self.inertia + mass * distance**2)


@dataclass(frozen=True)
class Frame:
    """What is strapped to the shank, and turns about the knee's axis with the motor's rotor."""

    mass: float  # kg
    distance: float  # m
    inertia: float  # kg m^2, about the axis, with the rotor's
    friction: float  # N m, dry
    damping: float  # N m s/rad
    cuff_stiffness: float  # N m/rad: straps and flesh between frame and shank
    cuff_damping: float  # N m s/rad

    @property
    def weight(self) -> float:
        """m l g [N m]."""
        return self.mass * self.distance * GRAVITY


@dataclass(frozen=True)
class Body:
    """Somebody, as a scale and a tape tell, and the leg, as nobody is told."""

    mass: float  # kg
    height: float  # m
    leg: Leg


def draw_body(rng: np.random.Generator) -> Body:
    """An adult with a relaxed knee."""
    one = person(rng, "adult")
    leg = Leg(one.mass, one.com_distance, one.inertia, one.stiffness, one.damping)
    return Body(one.body_mass, one.height, leg)


def draw_frame(rng: np.random.Generator, friction: float) -> Frame:
    """Of an exoskeleton of 0.8 to 1.4 kg, with dry friction of up to `friction` [N m]."""
    mass, distance = rng.uniform(0.8, 1.4), rng.uniform(0.12, 0.2)
    inertia = 1.3 * mass * distance**2 + rng.uniform(0.005, 0.02)
    stiffness = rng.uniform(300.0, 900.0)
    damping = 2 * rng.uniform(0.3, 0.6) * np.sqrt(stiffness * inertia)
    return Frame(
        mass,
        distance,
        inertia,
        rng.uniform(0.0, friction),
        rng.uniform(0.01, 0.05),
        stiffness,
        damping,
    )
