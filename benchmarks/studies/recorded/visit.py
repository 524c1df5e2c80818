"""One leg on one day: five drops by a hand, as its device wrote them down."""

from dataclasses import dataclass, field

import numpy as np
from benchmarks.others.case import Case
from benchmarks.others.devices import Errors
from benchmarks.others.effects import NOTHING
from benchmarks.others.leg import Physics
from benchmarks.others.measure import Columns, measure
from benchmarks.others.people import Person as Somebody
from benchmarks.others.protocol import Drop, Protocol, draw_tremor
from benchmarks.others.session import hold_session

from .world import LEAST, Person, World

FAULTS = ("cut", "slip", "lost", "twice")
HIGHEST, LOWEST = -0.05, -0.35  # rad, from which legs are dropped
CUT = (1.2, 3.0)  # s after the release at which a recording was stopped
SLIP = (0.05, 0.15)  # rad, by which a cuff slips
LOST, GAP = 0.08, 0.25  # share of samples that are missing here and there; s that are missing
BIAS, ZERO = 5e-4, 0.01  # rad/s, rad: a gyro's after it was zeroed, and an encoder's


@dataclass(frozen=True)
class Kept:
    """A drop as it was kept: `time` begins at 0 [s]."""

    time: np.ndarray
    columns: Columns


@dataclass(frozen=True, eq=False)
class Visit:
    """Of each drop: `damping` over inertia [1/s], how many times as stiff as usual the leg is, and
    from where it is dropped [rad].
    """

    person: Person
    side: int
    day: int
    fault: str  # of FAULTS, or empty
    damping: np.ndarray
    tone: np.ndarray
    starts: np.ndarray
    drops: tuple[Kept, ...] = field(repr=False)


def hold_visit(
    world: World, person: Person, where: tuple[int, int], draw: np.random.Generator
) -> Visit:
    """The drops of a side on a day."""
    side, day = where
    fault = str(draw.choice(FAULTS)) if draw.random() < world.bad else ""
    damping, tone = of_drops(world, float(person.damping[side, day]), draw)
    starts = draw.uniform(LOWEST, HIGHEST, world.drops)
    errors = Errors(bias=float(draw.normal(0, BIAS)), zero=float(draw.normal(0, ZERO)))
    slips = int(draw.integers(world.drops)) if fault == "slip" else -1
    drops = []
    for number, each in enumerate(zip(damping.tolist(), tone.tolist(), strict=True)):
        how = (float(starts[number]), fault == "cut")
        kept = hold_drop(person, person.physics(*each), errors, how, draw)
        kept = slipped(kept, draw) if number == slips else kept
        drops.append(holed(kept, draw) if fault == "lost" else kept)
    return Visit(person, side, day, fault, damping, tone, starts, tuple(drops))


def of_drops(world: World, usual: float, draw: np.random.Generator) -> tuple[np.ndarray, ...]:
    """Damping over inertia [1/s] of each drop, and how many times as stiff as usual it is."""
    damping = np.maximum(usual + draw.normal(0, world.drop, world.drops), LEAST)
    return damping, 1.0 + draw.normal(0, world.tone, world.drops)


def hold_drop(
    person: Person,
    physics: Physics,
    errors: Errors,
    how: tuple[float, bool],
    draw: np.random.Generator,
) -> Kept:
    """Held, let go, and left until it rests. `how` is from where, and whether somebody stops the
    recording before.
    """
    (start, cut), device = how, person.device
    tremor = draw_tremor(device.angle_noise, shaky=False, rng=draw)
    drop = Drop(
        angle=start,
        hold=float(draw.uniform(0.5, 1.2)),
        ramp=float(draw.uniform(0.02, 0.08)),
        end="stopped" if cut else "rest",
        swing=float(draw.uniform(*CUT)),
        after=float(draw.uniform(0.2, 0.6)),
        skipped=0.0,
        tremor=tremor,
    )
    protocol = Protocol((drop,), table=False, hanging=0.0)
    somebody = Somebody("adult", person.bare, None, None)
    about = ("", somebody, device, "none", NOTHING, False, physics, errors, protocol)
    case = Case(*about)
    (segment,) = measure(case, hold_session(physics, protocol), draw)
    return Kept(segment.time - segment.time[0], segment.columns)


def slipped(kept: Kept, draw: np.random.Generator) -> Kept:
    """The cuff slips while the leg swings, and stays there."""
    since = kept.time > draw.uniform(0.35, 0.6) * kept.time[-1]
    by = float(draw.uniform(*SLIP) * draw.choice([-1, 1])) * since
    angles = ("raw_angle_rad", "angle_rad")
    return Kept(kept.time, {n: c + by * (n in angles) for n, c in kept.columns.items()})


def holed(kept: Kept, draw: np.random.Generator) -> Kept:
    """Samples are missing here and there, and for a while."""
    begin = draw.uniform(0.3, 0.7) * kept.time[-1]
    there = (draw.random(kept.time.size) > LOST) & ~(
        (kept.time > begin) & (kept.time < begin + GAP)
    )
    there[[0, -1]] = True
    return Kept(kept.time[there], {name: each[there] for name, each in kept.columns.items()})
