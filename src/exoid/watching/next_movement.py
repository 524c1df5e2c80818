"""Which movement would tell most next, by the belief's own information.

The full plan fits anew and takes seconds. Here every candidate's samples are made from what is
believed, and the estimator itself takes them in: what error it has then is what it would have.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from math import radians

from exoid import online
from exoid.recordings.recording import Subject
from exoid.watching.goals import Goal
from exoid.watching.known import RATIOS, SCALED, known_of
from exoid.watching.load import Load, doubt_of
from exoid.watching.moment import Quantity
from exoid.watching.movement import Movement, samples_of

HOLDS = tuple(radians(each) for each in (-10, -30, -50, -70))  # the leg hangs at about -75
WEIGHT = 1.0, 0.4  # kg, m: what a person may strap on
WORTH = 0.9  # of an error, which is left at most by a movement that is worth its time

Errors = Mapping[str, Quantity]


@dataclass(frozen=True)
class Advice:
    """A movement, and what it would do to the error that lacks most; no movement is worth it where
    `movement` is None.
    """

    movement: Movement | None
    name: str
    before: float  # standard error in `unit`
    after: float
    unit: str

    @property
    def words(self) -> str:
        if self.movement is None:
            return "no drop would narrow it noticeably"
        return self.movement.words


@dataclass(frozen=True)
class Wish:
    """What is to be known better, of a leg that is estimated by a model, with what hangs on it."""

    model: online.Model
    load: Load
    goals: Sequence[Goal] = ()


def advise(belief: online.Belief, wish: Wish, after: float) -> Advice:
    """What to do after the time `after` [s] of the belief's last sample."""
    before = known_of(belief, wish.model, wish.load.doubt)
    carried = wish.load.at(after)
    found = {
        each: expected_after(each, belief, wish, after)
        for each in candidates(before, wish.goals, carried)
    }
    best = min(found, key=lambda each: lacking(found[each], wish.goals)[1])
    name, left = lacking(found[best], wish.goals)
    had = lacking(before, wish.goals)[1]
    known = before[name]
    return Advice(
        movement=best if left < WORTH * had else None,
        name=name,
        before=known.error,
        after=found[best][name].error,
        unit=known.unit,
    )


def candidates(
    known: Errors, goals: Sequence[Goal], carried: tuple[float, float]
) -> Iterator[Movement]:
    """Drops with what is on the leg; and with a mass of another weight where a goal is as large as
    the inertia, which no drop of one weight tells.
    """
    for hold in HOLDS:
        yield Movement(hold, *carried)
    if any(known[goal.name].unit.startswith(SCALED) for goal in goals):
        other = (0.0, 0.0) if carried[0] else WEIGHT
        for hold in HOLDS:
            yield Movement(hold, *other)


def expected_after(movement: Movement, belief: online.Belief, wish: Wish, after: float) -> Errors:
    """What would be known after it."""
    samples = samples_of(movement, belief, wish.model, after)
    doubt = wish.load.doubt
    if movement.mass and not doubt:
        doubt = doubt_of(Subject(), movement.mass, movement.distance)
    return known_of(online.replay(belief, samples, wish.model)[0], wish.model, doubt)


def lacking(known: Errors, goals: Sequence[Goal]) -> tuple[str, float]:
    """The quantity that is farthest from its goal, and its error over the wanted one.

    Without goals that is the worst ratio, as the share of a swing that its error makes.
    """
    if not goals:
        gravity = abs(known[RATIOS[0]].value)
        sizes = dict(zip(RATIOS, (gravity, gravity, gravity**0.5), strict=True))
        return max(((name, known[name].error / sizes[name]) for name in RATIOS), key=second)
    each = [(goal.name, distance_of(goal, known[goal.name])) for goal in goals]
    return max(each, key=second)


def distance_of(goal: Goal, known: Quantity) -> float:
    wanted = goal.wanted * (abs(known.value) if goal.relative else 1.0)
    return known.error / wanted if wanted > 0 else float("inf")


def second(pair: tuple[str, float]) -> float:
    return pair[1]
