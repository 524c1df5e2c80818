"""A session: a leg is learned in 10 s, then carried; another person sits down, and so on anew."""

from dataclasses import dataclass, replace

import numpy as np
from benchmarks.closed_loop.acts import Carry, Drop, Move
from benchmarks.closed_loop.carrying import LIMIT, NOTHING, Shares, carrying
from benchmarks.closed_loop.learners import Known, Learner
from benchmarks.closed_loop.plant import STEP, Motor, Plant
from benchmarks.closed_loop.rig import GRAVITY, Body, Frame
from benchmarks.closed_loop.sensors import Faults
from benchmarks.closed_loop.session import Session

DEGREE = np.pi / 180
LEAST_DROPS, MOST_DROPS = 2, 6
BEGUN = 0.5  # s of a movement that are not counted: the hand goes
HOLD = 0.9  # s that a hand holds the leg before it lets go
MASS, PLACE = 2.0, 0.2  # kg, m from the knee, of a weight that is strapped on
UNLIKELY = 0.5  # relative, of an inertia beside the one expected
PLACED = 3e-3  # m, by which it is strapped on elsewhere
LOADING = 0.8  # s in which the node hears its parameters, is armed and enabled


@dataclass(frozen=True)
class Case:
    """A rig, who sits in it, and by how much heavier the next one's leg is."""

    body: Body
    frame: Frame
    motor: Motor
    faults: Faults
    heavier: float  # share of mass and inertia; negative where it is lighter

    @property
    def next_body(self) -> Body:
        body = self.body
        return replace(
            body, mass=body.mass * (1 + self.heavier), leg=body.leg.heavier(self.heavier)
        )


@dataclass(frozen=True)
class Moved:
    """The person moves the leg, and the motor carries so much of it, by what was known."""

    name: str
    rows: slice  # of the log, once it is on its way
    shares: Shares
    known: Known | None  # None: the motor is off


@dataclass(frozen=True)
class Learned:
    """A leg, and how long it took from the first lift on."""

    drops: int
    seconds: float | None  # None: it never was known


class Script:
    """The acts of a session, one after the other."""

    def __init__(self, rng: np.random.Generator, case: Case, learner: Learner) -> None:
        self.case = case
        plant = Plant(case.body.leg, case.frame, case.motor)
        self.session = Session(rng, plant, case.faults, learner)
        self.moved: list[Moved] = []
        self.changed = 0.0  # s, when another person sat down
        self._rng = rng

    def drop(self) -> float:
        """5 s: a hand lifts the leg, lets it go and catches it. Returns when it let go [s]."""
        rng, session = self._rng, self.session
        top = rng.uniform(-25.0, 5.0) * DEGREE
        held = Carry(top, 0.1, HOLD)
        session.act(Carry(top, 0.6, 1.8 - HOLD))
        session.act(held)
        released = session.time
        session.act(Drop(rng.uniform(0.0, 0.06), 2.8, held))
        session.act(Carry(session.plant.hanging, 0.7, 0.4))
        return released

    def lay(self, seconds: float = 1.6) -> None:
        """A hand brings the leg to where it hangs, and holds it."""
        self.session.act(Carry(self.session.plant.hanging, 1.0, seconds))

    def learn(self) -> Learned:
        """Drops until the leg is known: two take 10 s."""
        begun = self.session.time
        for drops in range(1, MOST_DROPS + 1):
            self.drop()
            if drops >= LEAST_DROPS and self.session.learner.knows:
                self.lay()
                return Learned(drops, self.session.time - begun)
        return Learned(MOST_DROPS, None)

    def find_out(self, most: int) -> float | None:
        """Drops until another leg is found out; returns how long after its first release [s]."""
        first = None
        for _ in range(most):
            released = self.drop()
            self.lay()
            first = released if first is None else first
            doubted = self.session.doubted_since(released)
            if doubted is not None:
                return doubted - first
        return None

    def move(self, name: str, shares: Shares, known: Known | None) -> None:
        """Three times up and down: with what is known, or with the motor off."""
        session = self.session
        if known is not None:
            self.carry(known, shares)
        self.lay(1.0 + LOADING)
        session.follows = False
        rows = session.act(Move(55 * DEGREE, self._rng.uniform(1.6, 2.4), 6.5))
        self.moved.append(
            Moved(name, slice(rows.start + round(BEGUN / STEP), rows.stop), shares, known)
        )
        session.host.wants, session.shares = False, NOTHING
        self.lay()
        session.follows = True
        self.lay()  # a learner that looks again is not sure at once that it sees all

    def carry(self, known: Known, shares: Shares) -> None:
        """From when the node has heard it all, the motor carries what is known."""
        self.session.shares, self.session.host.wants = shares, True
        self.session.host.load(carrying(known, self.case.frame, shares), LIMIT)

    def seat_next(self) -> None:
        """Another person sits down, and tells nobody."""
        self.changed = self.session.time
        self.session.plant.seat(self.case.next_body.leg)

    def weigh(self, body: Body) -> Known | None:
        """Drops with a weight strapped on, whose mass M and place D are known, tell the inertia.

        (m l g + M D g) / (J + M D^2) is theirs, m l g / J that of the drops before. None where
        they are not known, or tell what is no leg's.
        """
        session, learner, leg = self.session, self.session.learner, self.session.plant.leg
        known = learner.leg()
        session.plant.seat(leg.loaded(MASS, PLACE + PLACED * self._rng.standard_normal()))
        session.learner = learner.anew(body)
        told = self.learn().seconds is not None
        loaded = session.learner.leg().gravity
        session.plant.seat(leg)
        self.lay()
        session.learner = learner
        self.lay()  # as behind a movement: it was not asked meanwhile
        if not (told and learner.knows):
            return None
        inertia = MASS * PLACE * (GRAVITY - loaded * PLACE) / (loaded - known.gravity)
        likely = abs(inertia / known.inertia - 1) < UNLIKELY
        return replace(known, inertia=inertia) if likely else None
