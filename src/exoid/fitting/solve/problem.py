"""The problem of a fit."""

from dataclasses import dataclass

import numpy as np

from exoid.fitting.data.conditioning_chain import Chain
from exoid.fitting.data.movement import Movement
from exoid.fitting.data.observation import Observation
from exoid.fitting.model.belief import Belief
from exoid.fitting.model.systematics import OWNED


@dataclass(frozen=True, eq=False)
class Problem:
    """Everything about a fit that does not depend on the start."""

    movements: list[Movement]
    observation: Observation
    known: np.ndarray
    belief: Belief
    chain: Chain
    owned: tuple[str, ...] = OWNED  # of the mounting: what is no unknown is as declared

    @property
    def steps(self) -> int:
        """Of the longest segment's simulation."""
        weights = self.observation.angle_weight + self.observation.velocity_weight
        return int(np.flatnonzero((np.asarray(weights) > 0).any(axis=0))[-1])

    @property
    def durations(self) -> list[float]:
        """Of every segment [s]."""
        return [float(each.segment.time[-1]) for each in self.movements]

    @property
    def kinds(self) -> list[str]:
        """Of every segment: passive, active or measured."""
        return [each.kind for each in self.movements]

    @property
    def longest_step(self) -> float:
        return float(np.diff(np.asarray(self.observation.time)).max())

    @property
    def unknowns(self) -> int:
        shared = int((self.known[:, :4] == 0).any(axis=0).sum())
        seat = np.asarray(self.observation.seat)
        free = self.known[:, 4:-3] == 0
        mounting = sum(int(free[seat == number].any(axis=0).sum()) for number in set(seat))
        return shared + mounting + int((self.known[:, -3:] == 0).sum())
