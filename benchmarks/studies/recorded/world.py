"""Who takes part: people of two groups whose legs are known, on every day and in every drop."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from benchmarks.others.devices import Device
from benchmarks.others.leg import Leg, Physics, physics_of
from benchmarks.others.people import draw_body, draw_table

GROUPS, SIDES = ("control", "spastic"), ("left", "right")
LEAST = 0.3  # 1/s, of the damping over inertia
STIFFNESS = 6.0, 1.5  # 1/s^2, over inertia: mean and standard deviation of people
SIZES = (0.01, 0.05)  # of dry friction, over m l g
DEGREE = np.pi / 180
DEVICES = (
    Device("node", 100.0, 0.03 * DEGREE, 0.007, 4096, 0.0, declared=True),
    Device("encoder_gyro", 50.0, 0.03 * DEGREE, 0.005, 16384, 0.0, declared=True),
    Device("camera", 50.0, 0.2 * DEGREE, None, 0, 0.0, declared=True),
)


@dataclass(frozen=True)
class World:
    """How people differ in damping over inertia [1/s], level by level, and what else they have."""

    people: int = 200
    days: int = 2
    drops: int = 5
    mean: float = 1.6
    effect: float = 0.45  # of the second group
    between: float = 0.22  # of people, one standard deviation
    side: float = 0.08
    day: float = 0.09
    side_on_day: float = 0.04
    drop: float = 0.04
    tone: float = 0.03  # of the stiffness, from drop to drop, relative
    friction: float = 0.3  # share of the second group's people whose knees rub
    bad: float = 0.12  # share of recordings with which something went wrong
    wrong_mass: float = 0.05  # share of people whose body mass was written down wrong
    no_mass: float = 0.05  # ... and not at all

    def damping(self, group: int, draw: np.random.Generator) -> np.ndarray:
        """Of each side on each day of a person."""
        lasting = self.mean + self.effect * group + draw.normal(0, self.between)
        sides = draw.normal(0, self.side, (len(SIDES), 1))
        days = draw.normal(0, self.day, (1, self.days))
        both = draw.normal(0, self.side_on_day, (len(SIDES), self.days))
        return np.maximum(lasting + sides + days + both, LEAST)


@dataclass(frozen=True, eq=False)
class Person:
    """One of them. `damping` is over inertia, (side, day); `friction` over m l g."""

    id: str
    group: int
    age: int  # years
    height: float  # m
    body_mass: float  # kg
    bare: Leg
    damping: np.ndarray
    friction: float
    device: Device
    written_mass: float | None  # kg

    @cached_property
    def rubs(self) -> bool:
        return self.friction > 0.0

    def physics(self, damping: float, tone: float = 1.0) -> Physics:
        """Of a leg with so much damping over inertia [1/s], so many times as stiff as usual."""
        bare = self.bare
        leg = bare._replace(damping=damping * bare.inertia, stiffness=tone * bare.stiffness)
        return physics_of(leg, friction=self.friction * leg.weight)


def draw_person(world: World, number: int, draw: np.random.Generator) -> Person:
    group = number % len(GROUPS)
    height, body_mass = draw_body("adult", draw)
    mass, distance, length = draw_table(draw)
    mass, distance = mass * body_mass, distance * height
    inertia = mass * distance * length * height
    stiffness = max(draw.normal(*STIFFNESS), 1.0) * inertia
    rubs, size = draw.random() < world.friction, float(draw.uniform(*SIZES))
    return Person(
        id=f"sub-{number:04d}",
        group=group,
        age=int(draw.integers(20, 70)),
        height=height,
        body_mass=body_mass,
        bare=Leg(mass, distance, inertia, stiffness, 0.0),
        damping=world.damping(group, draw),
        friction=size if rubs and group == 1 else 0.0,
        device=DEVICES[int(draw.integers(len(DEVICES)))],
        written_mass=written(world, body_mass, draw),
    )


def written(world: World, mass: float, draw: np.random.Generator) -> float | None:
    """As a hurried hand wrote it down: a digit lost, pounds for kilograms, or nothing."""
    chance = draw.random()
    if chance < world.no_mass:
        return None
    if chance < world.no_mass + world.wrong_mass:
        return round(mass * float(draw.choice([0.1, 2.2046])), 1)
    return round(mass, 1)
