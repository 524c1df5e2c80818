"""Where candidates are tried: many at once on the same recording, by the compiled program."""

from collections import Counter
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import product

import jax
import numpy as np
from jaxtyping import Float

from exoid.diagnose.consistency import Consistency
from exoid.diagnose.pinned import MOST, Clock, Course, Effect, Given, Pinned
from exoid.fit.coordinates import TYPICAL, Coordinates, flattened, scaled, unflattened, unscaled
from exoid.fit.local import columns
from exoid.fit.observation import Observation
from exoid.fit.problem import Problem
from exoid.fit.program import called
from exoid.physics.library import name_of
from exoid.physics.parameter import Declaration, declarations
from exoid.physics.step import Drive
from exoid.physics.term import Term

GIVEN = 4  # first terms that lanes may have linear, the first of them none
FARTHEST = 5.0  # typical steps of the inertia from the fit: a factor of four
ROWS, TABLE = np.zeros((1, 1, 1)), np.zeros((1, 1, 1, 1))
NONE = Effect(Drive(ROWS, ROWS, ROWS), ROWS)
PINNED = jax.tree.structure(Pinned(TABLE, Course(ROWS, ROWS, ROWS), NONE))
RELEASED = jax.tree.structure((TABLE, TABLE))


@dataclass(frozen=True, eq=False)
class Linear:
    """A first term as it was found: what it does, linear in its parameters around `at`."""

    effect: Effect
    at: np.ndarray


@dataclass(frozen=True, eq=False)
class Candidate:
    """Terms with their values, and the leg that goes with them."""

    terms: tuple[type[Term], ...]
    values: tuple[np.ndarray, ...]
    point: Float[np.ndarray, " coordinate"]  # `flattened` and in units of TYPICAL
    zero: np.ndarray = field(default_factory=lambda: np.zeros(2))  # gyro [rad/s], encoder [rad]
    linear: Linear | None = None  # in place of its first term, while it is pinned

    @property
    def unknowns(self) -> np.ndarray:
        """Everything a fit may change, in one row."""
        return np.concatenate([self.point, self.zero, *self.values])

    def at(self, unknowns: np.ndarray) -> "Candidate":
        """The same terms elsewhere."""
        size = self.point.size
        cuts = np.cumsum([2, *(value.size for value in self.values)])[:-1]
        zero, *values = np.split(unknowns[size:], cuts)
        return replace(self, point=unknowns[:size], zero=zero, values=tuple(values))


@dataclass(frozen=True, eq=False)
class Products:
    """(J, r)'(J, r) of a candidate: over all its unknowns, of every segment."""

    each: Float[np.ndarray, "segment column column"]

    @cached_property
    def total(self) -> np.ndarray:
        return self.each.sum(axis=0)

    @property
    def square(self) -> float:
        """The sum of squares of the residual over its noise."""
        return float(self.total[-1, -1])


@dataclass(frozen=True, eq=False)
class Bench:
    """A recording ready for candidates."""

    problem: Problem
    sensors: Consistency
    library: tuple[type[Term], ...]
    clock: Clock
    log_inertia: float  # log(J / kg m^2) of the baseline's fit
    rig: bool  # whose encoder has its zero anywhere

    @property
    def seen(self) -> Observation:
        return self.problem.observation

    @cached_property
    def course(self) -> Course:
        """What the sensors show, in the shape of the observation."""
        size = self.seen.time.shape[1]

        def padded(name: str) -> np.ndarray:
            rows = [getattr(each, name) for each in self.sensors.references]
            return np.stack([np.pad(row, (0, size - row.size), mode="edge") for row in rows])

        return Course(*map(padded, ("angle", "angular_velocity", "angular_acceleration")))

    @cached_property
    def places(self) -> np.ndarray:
        """Which coordinate every baseline unknown of a segment is."""
        like = self.like
        return columns(like, self.seen.seat)

    @cached_property
    def like(self) -> Coordinates:
        from exoid.fit.starts import usual_mounting

        count = len(self.problem.movements)
        rows = [np.zeros(count)] * 3
        shared = jax.tree.map(lambda _: np.zeros(()), TYPICAL.shared)
        own = jax.tree.unflatten(jax.tree.structure(TYPICAL.own), rows)
        return Coordinates(shared, np.zeros(()), usual_mounting(self.problem.movements), own)

    def coordinates(self, candidate: Candidate) -> Coordinates:
        return unscaled(unflattened(candidate.point, self.like))

    def point(self, coordinates: Coordinates) -> np.ndarray:
        return flattened(scaled(coordinates))

    def starts(self, term: type[Term]) -> list[np.ndarray]:
        """Where the search for a term begins: what the sensors said among themselves, else as
        declared.
        """
        for error in self.sensors.errors:
            if error.name == name_of(term):
                return [np.array([error.value])]
        low, high = self.range
        each = [
            declared.starts(low, high) if callable(declared.starts) else declared.starts
            for _, declared in declarations(term)
        ]
        return [np.array(row) for row in product(*each)]

    @cached_property
    def range(self) -> tuple[float, float]:
        """Lowest and highest angle [rad]."""
        angles = np.concatenate([each.angle for each in self.sensors.references])
        return float(angles.min()), float(angles.max())

    @cached_property
    def room(self) -> dict[type[Term], int]:
        """How many requests of every term the compiled program takes at once."""
        return {term: max(2, len(self.starts(term))) for term in self.library}

    def evaluate(
        self, candidates: list[Candidate], courses: list[Course], observation: Observation
    ) -> list[tuple[Products, Course]]:
        """The products of every candidate, and the course along which they are."""
        results: list[tuple[Products, Course] | None] = [None] * len(candidates)
        waiting = list(range(len(candidates)))
        while waiting:
            batch, waiting = self.packed(waiting, candidates)
            found = self.run(batch, candidates, courses, observation)
            for lane, number in enumerate(batch):
                each = self.placed(candidates[number], found.gram[lane])
                own = jax.tree.map(lambda leaf, lane=lane: leaf[lane], found.course)
                results[number] = (Products(each), own)
        return results  # type: ignore[return-value]

    @property
    def lanes(self) -> int:
        return sum(self.room.values())

    def packed(self, waiting: list[int], candidates: list[Candidate]):
        """As many of the waiting as fit into one run, and the rest."""
        used: Counter[type[Term]] = Counter()
        batch, rest = [], []
        given: list[Linear] = []
        for number in waiting:
            one = candidates[number]
            wanted = Counter(one.terms if one.linear is None else one.terms[1:])
            known = one.linear is None or any(one.linear is other for other in given)
            fits = all(used[term] + n <= self.room[term] for term, n in wanted.items())
            if fits and len(batch) < self.lanes and (known or len(given) < GIVEN - 1):
                used += wanted
                batch.append(number)
                given += [] if known or one.linear is None else [one.linear]
            else:
                rest.append(number)
        return batch, rest

    def run(self, batch, candidates, courses, observation) -> Pinned:
        lanes = self.lanes + 1  # the last one takes the requests that nobody made
        values, owners, slots = [], [], []
        for term in self.library:
            size = len(list(declarations(term)))
            value = np.tile(self.starts(term)[0], (self.room[term], 1)).reshape(-1, size)
            owner = np.full(self.room[term], lanes - 1)
            slot = np.zeros(self.room[term], dtype=int)
            made = 0
            for lane, number in enumerate(batch):
                one = candidates[number]
                for at, (own, numbers) in enumerate(zip(one.terms, one.values, strict=True)):
                    if own is term and not (at == 0 and one.linear is not None):
                        value[made], owner[made], slot[made] = numbers, lane, at
                        made += 1
            values.append(value)
            owners.append(owner)
            slots.append(slot)
        chosen = [*batch, *[batch[0]] * (lanes - len(batch))]
        points = [self.coordinates(candidates[number]) for number in chosen]
        stacked = jax.tree.map(lambda *leaves: np.stack(leaves), *points)
        course = jax.tree.map(lambda *leaves: np.stack(leaves), *[courses[n] for n in chosen])
        arguments = (
            tuple(values),
            tuple(owners),
            tuple(slots),
            self.given([candidates[number] for number in chosen]),
            stacked,
            np.array([candidates[number].zero for number in chosen]),
            course,
            self.course,
            observation,
            self.problem.known,
            self.clock,
            np.asarray(self.problem.steps),
        )
        static = (self.library, self.problem.chain)
        return called("exoid.diagnose.pinned:evaluate", arguments, static, PINNED)

    def given(self, lanes: list[Candidate]) -> Given:
        """The first terms that are linear, each once, and whose they are."""
        segments, size = self.seen.time.shape
        room = (1 + MOST, segments)
        push = np.zeros((*room, size - 1))
        effects = [Effect(Drive(push, push, push), np.zeros((*room, size, 2)))]
        known: list[Linear] = []
        whose, change = np.zeros(len(lanes), int), np.zeros((len(lanes), MOST))
        for lane, one in enumerate(lanes):
            if one.linear is None:
                continue
            if not any(one.linear is other for other in known):
                known.append(one.linear)
                effects.append(one.linear.effect)
            whose[lane] = 1 + next(k for k, other in enumerate(known) if other is one.linear)
            moved = one.values[0] - one.linear.at
            change[lane, : moved.size] = moved
        effects += [effects[0]] * (GIVEN - len(effects))
        stacked = jax.tree.map(lambda *leaves: np.stack(leaves), *effects)
        return Given(stacked, whose, change)

    def linear(self, candidates: list[Candidate], courses: list[Course]) -> list[Linear]:
        """What the terms of a few candidates do along their courses."""
        found = self.run(list(range(len(candidates))), candidates, courses, self.seen).first
        return [
            Linear(jax.tree.map(lambda leaf, lane=lane: leaf[lane], found), one.values[0])
            for lane, one in enumerate(candidates)
        ]

    def release(
        self, candidates: list[Candidate], observation: Observation
    ) -> list[tuple[Products, np.ndarray]]:
        """The products of candidates running free, one after the other, and what they show."""
        return [self.release_one(each, observation) for each in candidates]

    def release_one(
        self, candidate: Candidate, observation: Observation
    ) -> tuple[Products, np.ndarray]:
        arguments = (
            candidate.values,
            self.coordinates(candidate),
            candidate.zero,
            observation,
            self.problem.known,
            self.clock,
            np.asarray(self.problem.steps),
        )
        static = (candidate.terms, self.problem.chain)
        gram, shown = called("exoid.diagnose.free:release", arguments, static, RELEASED)
        return Products(self.spread(candidate, gram, range(gram.shape[-1]))), shown

    def placed(self, candidate: Candidate, gram: np.ndarray) -> np.ndarray:
        """The products over all unknowns of a candidate."""
        base = self.places.shape[1]
        rows = [*range(base + 2)]
        for slot, value in enumerate(candidate.values):
            rows += list(base + 2 + slot * MOST + np.arange(value.size))
        return self.spread(candidate, gram, [*rows, gram.shape[-1] - 1])

    def spread(self, candidate: Candidate, gram: np.ndarray, rows) -> np.ndarray:
        """The rows of a segment's products at their places among all unknowns."""
        total = candidate.unknowns.size + 1
        others = range(candidate.point.size, total)
        each = np.zeros((len(gram), total, total))
        for segment, place in enumerate(self.places):
            at = np.array([*place, *others])
            each[segment][np.ix_(at, at)] = gram[segment][np.ix_(rows, rows)]
        return each

    def bounds(self, candidate: Candidate) -> tuple[np.ndarray, np.ndarray]:
        """Of every unknown: the leg neither pulls apart nor makes energy, a term keeps its own."""
        size = candidate.unknowns.size
        lower, upper = np.full(size, -np.inf), np.full(size, np.inf)
        lower[[1, 3]] = 0.0  # gravity, damping
        lower[2] = -np.inf if self.rig else 0.0  # stiffness
        inertia = self.log_inertia / float(TYPICAL.shared.log_inertia)
        lower[0], upper[0] = inertia - FARTHEST, inertia + FARTHEST
        each: list[Declaration] = [
            declared for term in candidate.terms for _, declared in declarations(term)
        ]
        first = candidate.point.size + 2
        if not self.rig:
            lower[first - 1] = upper[first - 1] = 0.0
        lower[first:] = [declared.lower for declared in each]
        upper[first:] = [declared.upper for declared in each]
        return lower, upper
