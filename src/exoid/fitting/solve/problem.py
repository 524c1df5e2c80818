"""The problem of a fit."""

from dataclasses import dataclass, replace

import jax
import numpy as np

from exoid.fitting.data.conditioning_chain import Chain
from exoid.fitting.data.movement import Movement, absent_of
from exoid.fitting.data.observation import Observation
from exoid.fitting.data.stage import Stage
from exoid.fitting.model.belief import Belief
from exoid.fitting.model.coordinates import SegmentUnknowns, Shared, Unknowns, quantity_names
from exoid.fitting.model.limits import constraint_names
from exoid.fitting.model.mounting import Mounting
from exoid.fitting.model.systematics import OWNED, by_recording, is_exact
from exoid.fitting.model.term_parameters import parameters_of, term_of
from exoid.physics.term import Term

STRICT = 1e4  # first penalty of a term's own limits, which hold without a prior too


@dataclass(frozen=True, eq=False)
class Problem:
    """Everything about a fit that does not depend on the start."""

    movements: list[Movement]
    observation: Observation
    known: Unknowns  # 1 for what plays no part, by segment
    belief: Belief
    chain: Chain
    owned: tuple[str, ...] = OWNED  # of the mounting: what is no unknown is as declared
    terms: tuple[type[Term], ...] = ()

    @property
    def steps(self) -> int:
        """Of the longest segment's simulation."""
        weights = self.observation.angle_weight + self.observation.velocity_weight
        return int(np.flatnonzero((np.asarray(weights) > 0).any(axis=0))[-1])

    @property
    def free(self) -> Stage:
        """The whole of every segment, tied to nothing."""
        return Stage(np.asarray(0.0), np.asarray(self.steps), compact=bool(self.terms))

    @property
    def samples(self) -> np.ndarray:
        """Measured numbers that count, of every segment."""
        seen = self.observation
        weights = np.stack([seen.angle_weight, seen.velocity_weight])
        return np.sum(weights > 0, axis=(0, 2))

    def own_rows(self, number: int) -> np.ndarray:
        """Which rows of the observation the samples of a segment are."""
        time = np.asarray(self.observation.time[number])
        return np.searchsorted(time, self.movements[number].segment.time)

    @property
    def durations(self) -> list[float]:
        """Of every segment [s]."""
        return [float(each.segment.time[-1]) for each in self.movements]

    @property
    def kinds(self) -> list[str]:
        """Of every segment: passive, active or measured."""
        return [each.kind for each in self.movements]

    @property
    def absent(self) -> frozenset[str]:
        """What of Eq. 9 the rig is said not to have: gravity, stiffness."""
        return absent_of(self.movements)

    @property
    def gain_known(self) -> bool:
        """Is every torque that was measured in N m?"""
        return all(each.gain_known for each in self.movements if each.kind == "measured")

    @property
    def voluntary(self) -> list[int]:
        """The segments that a voluntary torque moved."""
        return [number for number, each in enumerate(self.movements) if each.voluntary]

    @property
    def recordings(self) -> list[list[Movement]]:
        """The movements of every recording, by its seat."""
        return by_recording(self.movements)

    @property
    def longest_step(self) -> float:
        """Of the simulation [s]."""
        seen = self.observation
        return float(np.diff(np.asarray(seen.time)).max()) / seen.parts

    @property
    def unknowns(self) -> int:
        def free(each) -> list[np.ndarray]:
            return [np.asarray(leaf) == 0 for leaf in jax.tree.leaves(each) if leaf.size]

        owner = np.asarray(self.observation.owner)
        together = sum(bool(leaf.any()) for leaf in free((self.known.shared, self.known.terms)))
        owned = [
            leaf[owner == number] for number in set(owner) for leaf in free(self.known.mounting)
        ]
        own = sum(int(leaf.sum()) for leaf in free(self.known.own))
        return together + sum(bool(leaf.any()) for leaf in owned) + own

    def estimates(self, name: str, entry: int) -> bool:
        """Is what this recording owns an unknown of the fit?"""
        if name not in self.owned:
            return False
        own = np.asarray(self.observation.owner) == entry
        return bool((getattr(self.known.mounting, name)[own] == 0).any())

    def estimated(self, name: str) -> list[int]:
        """The recordings of which this is an unknown of the fit."""
        return [n for n in range(len(self.recordings)) if self.estimates(name, n)]

    def deviation_of(self, name: str) -> np.ndarray:
        """How well this is known of every recording: one standard deviation."""
        return np.asarray(getattr(self.belief.prior.mounting, name))

    @property
    def times_vouched(self) -> bool:
        """Does a gyro show by the same clock how fast all is, or a sidecar say how good that is?"""
        said = any("clock" in own[0].systematics.declared for own in self.recordings)
        return said or any(each.gyro_noise for each in self.movements)

    def widened(self, **deviations: np.ndarray) -> "Problem":
        """The same with these standard deviations of what recordings own."""
        prior = self.belief.prior
        assert prior.mounting is not None  # `pose` gives one
        mounting = replace(prior.mounting, **deviations)
        return replace(self, belief=replace(self.belief, prior=replace(prior, mounting=mounting)))

    def limits_of_term(self, name: str) -> tuple[float, float]:
        """Lower and upper end of a term's parameter, as coulomb_friction.level."""
        limits = self.belief.limits
        row = [each for each, _ in parameters_of(self.terms)].index(name)
        lower, upper = (
            float(jax.tree.leaves(each)[row]) for each in (limits.lower_terms, limits.upper_terms)
        )
        return lower, upper

    @property
    def tells_inertia(self) -> bool:
        """Does the inertia play a part in any segment?"""
        return bool((self.known.shared.log_inertia == 0).any())

    @property
    def quantities(self) -> list[str]:
        """Which quantity every row of `coordinates.quantities` is."""
        return quantity_names(len(self.movements), self.terms)

    def quantities_of(self, name: str) -> list[str]:
        """Those of this name: one, or one of every voluntary segment."""
        each = [f"{name}[{number}]" for number in self.voluntary]
        return [name] if name in self.quantities else each

    @property
    def constraints(self) -> list[str]:
        """What every row of `constraint.violations_at` limits."""
        return constraint_names(len(self.movements), self.terms)


def known_of(
    movements: list[Movement],
    belief: Belief,
    owned: tuple[str, ...],
    terms: tuple[type[Term], ...],
) -> Unknowns:
    """1 for what plays no part in a segment: the scale of a bare leg, what is exact, torques."""
    nothing = np.zeros(len(movements))
    raw = belief.raw  # Eq. 11 as printed knows nothing of mountings
    each = {
        name: np.array([[float(raw or is_exact(one, name, movements))] for one in movements])
        for name in owned
    }
    none = np.zeros((len(movements), 0))
    bare = np.array([float(not one.scaled) for one in movements])
    relaxed = np.array([float(not one.voluntary) for one in movements])
    absent = absent_of(movements)
    shared = {name: nothing + float(name in absent) for name in ("gravity", "stiffness", "damping")}
    return Unknowns(
        Shared(bare, **shared),
        Mounting(**{name: each.get(name, none) for name in OWNED}),
        SegmentUnknowns(relaxed, nothing, nothing),
        tuple(jax.tree.map(lambda _: nothing, term_of(term, lambda *_: 0.0)) for term in terms),
    )
