"""A recording ready for candidates: what was seen, by which sensors, and where a search begins."""

from dataclasses import dataclass, replace
from functools import cached_property
from itertools import product
from typing import Any

import jax
import numpy as np

from exoid.fitting.data.movement import all_driven
from exoid.fitting.data.observation import Observation
from exoid.fitting.data.size_of_rig import scale_of
from exoid.fitting.misfit.neighbourhood import columns
from exoid.fitting.model.coordinates import (
    TYPICAL,
    Coordinates,
    Shared,
    flattened,
    scaled,
    unflattened,
    unscaled,
)
from exoid.fitting.model.systematics import deviations
from exoid.fitting.solve.problem import Problem
from exoid.mismatch.screen.hypothesis import Hypothesis, Products
from exoid.mismatch.screen.measured_motion import MeasuredMotion
from exoid.mismatch.sensors.agreement import Consistency
from exoid.physics.parameter import Declaration, declarations
from exoid.physics.scale import AS_A_LEG, Scale, ranged
from exoid.physics.sensing.angle_offset import AngleOffset
from exoid.physics.term import Moved, Term, name_of

OUTERMOST = 3.0  # standard deviations of a seat's tilt: one that is farther off is a cause
SOFTEST = 1e-3  # N m/rad, of a leg that has a rest angle
FOLLOWING = 10.0  # mean square over the noise, up to which a candidate needs no tether
FARTHEST = 5.0  # typical steps of the inertia from the fit: a factor of four


@dataclass(frozen=True, eq=False)
class PreparedRecording:
    """A recording ready for candidates."""

    problem: Problem
    sensors: Consistency
    library: tuple[type[Term], ...]
    log_inertia: float  # log(J / kg m^2) of the baseline's fit
    rig: bool
    zero: float  # rad, standard deviation of the encoder's; 0 where it is known
    common: tuple[type[Term], ...] = ()  # first terms of every candidate: sure errors of sensors
    tethers: tuple[float, ...] = ()  # rad/s, by which candidates are led where a baseline drifts

    @property
    def zeros(self) -> tuple[str, ...]:
        """Of the first recording's sensors what every candidate leaves free (`Hypothesis.zero`)."""
        return ("gyro_bias", "zero") if self.zero > 0 else ("gyro_bias",)

    @property
    def segments(self) -> int:
        return len(self.problem.movements)

    @property
    def seen(self) -> Observation:
        return self.problem.observation

    @cached_property
    def has_gyro(self) -> bool:
        """Does one watch the encoder?"""
        return bool((self.seen.velocity_weight > 0).any())

    @cached_property
    def scale(self) -> Scale:
        """How large a rig's motion is beside a leg's."""
        return scale_of(self.problem.movements) if self.rig else AS_A_LEG

    @cached_property
    def samples(self) -> int:
        """How many samples of both channels there are."""
        seen = self.seen
        return int((seen.angle_weight > 0).sum() + (seen.velocity_weight > 0).sum())

    @cached_property
    def measured_motion(self) -> MeasuredMotion:
        """What the sensors show, in the shape of the observation."""
        size = self.seen.time.shape[1]

        def padded(name: str) -> np.ndarray:
            rows = [getattr(each, name) for each in self.sensors.references]
            return np.stack([np.pad(row, (0, size - row.size), mode="edge") for row in rows])

        return MeasuredMotion(*map(padded, ("angle", "angular_velocity", "angular_acceleration")))

    def untethered(self, square: float) -> "PreparedRecording":
        """The same for what comes beside a candidate that leaves so much: where that follows the
        motion nothing need be led, and a tether would hide what acts slowly, as a spring's rest.
        """
        return replace(self, tethers=()) if square < FOLLOWING * self.samples else self

    @property
    def driven(self) -> bool:
        """Was the torque of every segment measured?"""
        return all_driven(self.problem.movements)

    @property
    def moved(self) -> Moved:
        """What moves in it, for words on what to record."""
        return "motor" if self.driven else "rig" if self.rig else "leg"

    @cached_property
    def places(self) -> np.ndarray:
        """Which coordinate every baseline unknown of a segment is."""
        return columns(self.like, self.seen.owner)

    @cached_property
    def usual(self) -> np.ndarray:
        """One over the standard deviation of what is known to be about nothing, though no leg need
        explain it: of every coordinate the tilts of seats, and of the two zeros the encoder's.
        """
        known = 1 / self.zero if self.zero > 0 else 0.0
        return np.array([*self.tilts, 0.0, known])

    @cached_property
    def tilts(self) -> np.ndarray:
        """One over the standard deviation of every seat's tilt, 0 at other coordinates."""
        nothing = jax.tree.map(np.zeros_like, self.like)
        spread = deviations(self.problem.movements, self.problem.owned).tilt
        mounting = replace(nothing.mounting, tilt=TYPICAL.mounting.tilt / spread)
        return flattened(replace(nothing, mounting=mounting))

    @cached_property
    def like(self) -> Coordinates:
        from exoid.fitting.multistart.beginning.starts import usual_mounting

        count = len(self.problem.movements)
        rows = [np.zeros(count)] * 3
        usual = usual_mounting(self.problem.movements, owned=self.problem.owned)
        shared = jax.tree.map(lambda _: np.zeros(()), TYPICAL.shared)
        own = jax.tree.unflatten(jax.tree.structure(TYPICAL.own), rows)
        return Coordinates(shared, np.zeros(()), usual, own)

    @cached_property
    def numbers(self) -> Coordinates:
        """Which coordinate each is."""
        return unflattened(np.arange(flattened(self.like).size), self.like)

    @cached_property
    def units(self) -> np.ndarray:
        """A typical step of every coordinate."""
        return flattened(unscaled(jax.tree.map(np.ones_like, self.like)))

    def coordinates(self, candidate: Hypothesis) -> Coordinates:
        return unflattened(candidate.point * self.units, self.like)

    def as_its_twin(self, candidate: Hypothesis, term: type[Term], size: Any) -> Any:
        """The size of the term named `same_torque` that pushes as much on a candidate's leg."""
        shared = self.coordinates(candidate).shared
        stiffness = float(shared.stiffness * np.exp(shared.log_inertia))
        return term.as_same_torque(size, max(stiffness, SOFTEST))

    def point(self, coordinates: Coordinates) -> np.ndarray:
        return flattened(scaled(coordinates))

    def products(self, candidate: Hypothesis, gram: np.ndarray) -> Products:
        """Every segment's products at their places among all unknowns."""
        total, usual = candidate.unknowns.size + 1, self.usual
        others = range(candidate.point.size, total)
        each = np.zeros((self.segments, total, total))
        for whole, own, place in zip(each, gram, self.places, strict=True):
            at = np.array([*place, *others])
            whole[np.ix_(at, at)] = own
        table = np.zeros((total - 1, total))
        table[range(usual.size), range(usual.size)] = usual
        table[: usual.size, -1] = usual * candidate.unknowns[: usual.size]
        return Products(each, table.T @ table)

    def starts(self, term: type[Term]) -> list[np.ndarray]:
        """Where the search for a term begins: what the sensors said among themselves, else as
        declared.
        """
        for error in self.sensors.errors:
            if error.name == name_of(term):
                return [np.array([error.value])]
        low, high = self.range
        each = [
            ranged(declared, self.scale).starts_between(low, high)
            for _, declared in declarations(term)
        ]
        return [np.array(row) for row in product(*each)]

    @cached_property
    def range(self) -> tuple[float, float]:
        """Lowest and highest angle [rad] between the first and the last sample that counts: beyond
        them no data hold the reference.
        """
        counts = np.asarray(self.seen.angle_weight + self.seen.velocity_weight) > 0
        angles = np.concatenate(
            [
                reference.angle[np.argmax(row) : row.size - np.argmax(row[::-1])]
                for reference, row in zip(self.sensors.references, counts, strict=True)
            ]
        )
        return float(angles.min()), float(angles.max())

    def bounds(self, candidate: Hypothesis) -> tuple[np.ndarray, np.ndarray]:
        """Of every unknown: the leg neither pulls apart nor makes energy, a term keeps its own."""
        size = candidate.unknowns.size
        lower, upper = np.full(size, -np.inf), np.full(size, np.inf)
        inertia = self.log_inertia / float(TYPICAL.shared.log_inertia)
        free = -np.inf if self.rig else 0.0  # of the stiffness
        axis = self.rig and self.driven  # which may point anywhere
        pull = -np.inf if axis else 0.0
        least = Shared(*map(np.asarray, (inertia - FARTHEST, pull, free, 0.0)))
        at = np.ravel(jax.tree.leaves(self.numbers.shared))
        lower[at] = jax.tree.leaves(least)
        upper[self.numbers.shared.log_inertia] = inertia + FARTHEST
        each: list[Declaration] = [
            ranged(declared, self.scale)
            for term in candidate.terms
            for _, declared in declarations(term)
        ]
        first = candidate.point.size + 2
        tilts = np.flatnonzero(self.tilts)
        upper[tilts] = OUTERMOST / self.tilts[tilts]
        upper[first - 1] = largest_zero() * (self.zero > 0)
        lower[tilts], lower[first - 1] = -upper[tilts], -upper[first - 1]
        lower[first:] = [declared.lower for declared in each]
        upper[first:] = [declared.upper for declared in each]
        return lower, upper


def largest_zero() -> float:
    """rad, of an encoder on a leg."""
    (declared,) = dict(declarations(AngleOffset)).values()
    return declared.upper
