"""Which movement would tell most next, by the belief's own information.

The full plan fits anew and takes seconds. Here every candidate's samples are made from what is
believed, and the estimator itself takes them in: what error it has then is what it would have.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from math import radians

from exoid.physics.anatomy.added_mass import changes_swing_least
from exoid.physics.anatomy.expected import ExpectedLeg
from exoid.physics.leg import GRAVITY
from exoid.watching.beside.goals import Goal
from exoid.watching.beside.movement import Movement, samples_of
from exoid.watching.estimate.expect import unloading
from exoid.watching.estimate.known import RATIOS, SCALED, known_of
from exoid.watching.estimate.leg import Person
from exoid.watching.estimate.load import Mass, expected_with
from exoid.watching.estimate.moment import Moment, Quantity
from exoid.watching.estimate.online import Belief, init, replay
from exoid.watching.estimate.unload import Told, unloaded

HOLDS = tuple(radians(each) for each in (-10, -30, -50, -70))  # the leg hangs at about -75
WEIGHT = 1.0, 0.4  # kg, m: what a person may strap on
WORTH = 0.9  # of an error, which is left at most by a movement that is worth its time

Errors = Mapping[str, Quantity]
Beliefs = Mapping[Mass, Belief]


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

    def holds(self, moment: Moment) -> bool:
        """Is the error before it the one of that moment, as far as that is known? A movement that
        goes on narrows it, and so would an answer that came late promise too much.
        """
        known = moment.quantities.get(self.name)
        return known is None or WORTH * self.before <= known.error <= self.before / WORTH

    @property
    def words(self) -> str:
        if self.movement is None:
            return "no drop would narrow it noticeably"
        return self.movement.words


@dataclass(frozen=True)
class Wish:
    """What is to be known better, and of whom; the weight that is on the leg now."""

    person: Person
    goals: Sequence[Goal] = ()


def advise(beliefs: Beliefs, wish: Wish, now: Mass, after: float) -> Advice:
    """What to do after the time `after` [s] of the last sample, with a weight on the leg now."""
    before, model = known_of_all(beliefs, wish), wish.person.model
    leg = as_known(wish.person.expected, before)

    def known_after(movement: Movement) -> dict[str, Quantity]:
        mass = movement.mass
        belief = beliefs[mass] if mass in beliefs else init(expected_with(leg, mass), model)
        belief, _ = replay(belief, samples_of(movement, belief, model, after), model)
        return known_of_all({**beliefs, mass: belief}, wish)

    found = {each: known_after(each) for each in candidates(beliefs, wish.goals, before, now)}
    best = min(found, key=lambda each: lacking(found[each], wish.goals)[1])
    left = lacking(found[best], wish.goals)[1]
    name, had = lacking(before, wish.goals)
    known = before[name]
    return Advice(
        movement=best if left < WORTH * had else None,
        name=name,
        before=known.error,
        after=found[best][name].error,
        unit=known.unit,
    )


def candidates(
    beliefs: Beliefs, goals: Sequence[Goal], known: Errors, now: Mass
) -> Iterator[Movement]:
    """Drops with the weight that is on the leg; and with another one where a goal is as large as
    the inertia, which no drops of one weight tell: at the ankle, where it changes damping most,
    and near the knee, where it changes m l g / J most.
    """
    masses = {now: None}
    if any(known[goal.name].unit.startswith(SCALED) for goal in goals):
        near = near_the_knee(known[RATIOS[0]].value)
        masses |= dict.fromkeys([*beliefs, Mass() if now.weight else Mass(*WEIGHT), *near])
    for mass in masses:
        for hold in HOLDS:
            yield Movement(hold, mass)


def near_the_knee(gravity: float) -> list[Mass]:
    """A weight that tells J by G = m l g / J, where damping under a load is not known."""
    where = round(changes_swing_least(gravity) / 2, 2) if gravity > 0 else 0.0
    return [Mass(WEIGHT[0], where)] if 0 < where < WEIGHT[1] else []


def as_known(expected: ExpectedLeg, known: Errors) -> ExpectedLeg:
    """The leg as it is known by now, in the place of any that is like this person's."""
    distance = known["gravity"].value / (expected.mass.value * GRAVITY)
    return replace(
        expected,
        com_distance=replace(expected.com_distance, value=distance),
        **{
            name: replace(getattr(expected, name), value=known[name].value)
            for name in ("inertia", "stiffness", "damping")
        },
    )


def known_of_all(beliefs: Beliefs, wish: Wish) -> dict[str, Quantity]:
    """Every quantity of the bare leg by what is believed of it with each weight."""
    person = wish.person
    each = {mass: known_of(belief, person.model) for mass, belief in beliefs.items()}
    first = each.get(Mass(), next(iter(each.values())))
    if not any(mass.weight for mass in beliefs):
        return first
    before = unloading(person.expected, person.subject, beliefs)
    bare = unloaded(before, {mass: told_in(known) for mass, known in each.items()})
    return first | {one.name: one for one in (*bare.ratios, *bare.absolute)}


def told_in(known: Errors) -> Told:
    return Told(
        tuple(known[name].value for name in RATIOS), tuple(known[name].error for name in RATIOS)
    )


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
