"""What is true of all people of whom a study draws some: difference of the groups, test and
retest. Each of many people is there twice, alike but for the group.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from benchmarks.others.leg import Physics
from benchmarks.others.motion import swing_freely
from benchmarks.others.protocol import resting_angle

from .visit import HIGHEST, LOWEST, of_drops
from .world import GROUPS, SIDES, Person, World, draw_person

TICK = 2e-3  # s
FIRST, LONG = 2.5, 12.0  # s until the first swing has turned; until a leg that rubs has stopped
DETECTABLE = 1.959964 * 2**0.5  # standard errors of measurement
Measured = Callable[[Person, float, float, float], float]


@dataclass(frozen=True)
class Truth:
    """`difference` is the second group less the first."""

    difference: float
    correlation: float
    change: float


def damping_over_inertia(person: Person, damping: float, tone: float, start: float) -> float:
    return damping


def relaxation_index(person: Person, damping: float, tone: float, start: float) -> float:
    """The first downswing over the way from start to rest, without a hand and without noise."""
    physics = person.physics(damping, tone)
    angle = swing_freely(physics, (start, 0.0), LONG if person.rubs else FIRST, TICK).angle
    rest = float(angle[-1]) if person.rubs else resting_angle(frictionless(physics))
    turned = int(np.argmax(np.diff(angle) > 0))  # the first that rises
    return (start - float(angle[turned])) / (start - rest)


def frictionless(physics: Physics) -> Physics:
    return physics._replace(friction=0.0)


QUANTITIES: dict[str, Measured] = {
    "damping_over_inertia": damping_over_inertia,
    "relaxation_index": relaxation_index,
}


def truth_of(world: World, measured: Measured, people: int, seed: int = 1_000_000) -> Truth:
    """Of so many people in either group; with more of them it is the more exact."""
    pairs = [
        [occasions(world, measured, (group, number, seed)) for group in range(len(GROUPS))]
        for number in range(people)
    ]
    found = np.array(pairs)  # person, group, side, day
    days = found.var(axis=3, ddof=1).mean()
    return Truth(
        difference=float((found[:, 1] - found[:, 0]).mean()),
        correlation=float(1.0 - days / found.var()),
        change=float(DETECTABLE * days**0.5),
    )


def occasions(world: World, measured: Measured, who: tuple[int, int, int]) -> np.ndarray:
    """The mean of the drops of a person, (side, day)."""
    group, number, seed = who
    draw = np.random.default_rng([seed, number])
    person = draw_person(replace(world, bad=0.0), group, draw)
    return np.array(
        [
            [day_of(world, measured, person, float(each), draw) for each in own]
            for own in person.damping
        ]
    ).reshape(len(SIDES), world.days)


def day_of(
    world: World, measured: Measured, person: Person, usual: float, draw: np.random.Generator
) -> float:
    damping, tone = of_drops(world, usual, draw)
    starts = draw.uniform(LOWEST, HIGHEST, world.drops)
    drops = zip(damping.tolist(), tone.tolist(), starts.tolist(), strict=True)
    return float(np.mean([measured(person, *each) for each in drops]))
