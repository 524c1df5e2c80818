"""Who takes part in a study whose recordings are fitted: people of two groups whose legs are known
on every day and in every drop. All is over J, as motion alone tells it.
"""

from dataclasses import dataclass, replace

import numpy as np
from benchmarks.people import leg
from benchmarks.studies.tables import Design, Truth, person

GRAVITY = 9.81  # m/s^2
LEAST = 0.2  # 1/s and 1/s^2, of what cannot be negative
SIZES = (0.01, 0.05)  # of dry friction, over m l g
ALIKE = 0.01  # of the two legs of a person, in m l g / J
FAULTS = ("noise", "late gyro", "moved zero")
EXACT = {"error": 0.0, "spread": 0.0, "bad": 0.0}
DAMPING = Truth(
    quantity="damping_over_inertia",
    unit="1/s",
    mean=1.6,
    between=0.22,
    side=0.08,
    day=0.09,
    side_on_day=0.04,
    drop=0.0,
    effect=0.165,
    **EXACT,
)
STIFFNESS = Truth(
    quantity="stiffness_over_inertia",
    unit="1/s^2",
    mean=6.0,
    between=1.2,
    side=0.3,
    day=0.35,
    side_on_day=0.2,
    drop=0.0,
    effect=0.0,
    **EXACT,
)
DESIGN = Design(truths=(DAMPING, STIFFNESS))


@dataclass(frozen=True)
class World:
    """`bad` is the share of recordings with which something went wrong; `unlike` how far the drops
    of a visit scatter, as a share of what the leg is.
    """

    design: Design = DESIGN
    bad: float = 0.1
    unlike: float = 0.0

    def of(self, people: int) -> "World":
        return replace(self, design=replace(self.design, people=people))


@dataclass(frozen=True, eq=False)
class Person:
    """`gravity` is m l g / J of either side [1/s^2]; `usual` has, by quantity, what each side is on
    each day; `friction` is over m l g.
    """

    id: str
    group: int
    body_mass: float  # kg
    height: float  # m
    gravity: np.ndarray
    usual: dict[str, np.ndarray]
    friction: float


@dataclass(frozen=True, eq=False)
class Visit:
    """A leg on a day; `drops` has of each quantity the truth of every drop."""

    person: Person
    side: int
    day: int
    fault: str  # of FAULTS, or empty
    drops: dict[str, np.ndarray]

    @property
    def kind(self) -> str:
        """What is wrong with the recording, and with the leg."""
        return " and ".join(filter(None, ("friction" * (self.person.friction > 0), self.fault)))

    def truth(self, quantity: str) -> float:
        """What the recording should tell."""
        return float(self.drops[quantity].mean())


def draw_person(world: World, number: int, draw: np.random.Generator) -> Person:
    design, group = world.design, number % world.design.groups
    height, index = draw.normal(1.72, 0.09), draw.normal(24.0, 2.7)
    mass, distance, inertia = leg(draw, height, index)
    usual = {each.quantity: person(each, design, group, draw).by_day for each in design.truths}
    rubs, size = draw.random() < design.friction, float(draw.uniform(*SIZES))
    return Person(
        id=f"sub-{number:03d}",
        group=group,
        body_mass=index * height**2,
        height=height,
        gravity=mass * distance * GRAVITY / inertia * (1 + draw.normal(0, ALIKE, design.sides)),
        usual={name: np.maximum(each, LEAST) for name, each in usual.items()},
        friction=size if rubs and group == 1 else 0.0,
    )


def draw_visits(world: World, one: Person, draw: np.random.Generator) -> list[Visit]:
    """Both sides on all days."""
    design = world.design
    found = []
    for side in range(design.sides):
        for day in range(design.days):
            drops = {
                name: each[side, day] * (1 + draw.normal(0, world.unlike, design.drops))
                for name, each in one.usual.items()
            }
            fault = str(draw.choice(FAULTS)) if draw.random() < world.bad else ""
            found.append(Visit(one, side, day, fault, drops))
    return found


def draw_study(world: World, seed: int) -> list[Visit]:
    """All visits of all people; `seed` decides everything."""
    draws = (np.random.default_rng([seed, number]) for number in range(world.design.people))
    return [
        visit
        for number, draw in enumerate(draws)
        for visit in draw_visits(world, draw_person(world, number, draw), draw)
    ]
