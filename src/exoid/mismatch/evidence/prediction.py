"""Segments as they are predicted without and with what was found."""

from dataclasses import dataclass
from typing import Annotated

import numpy as np
from jaxtyping import Bool, Float

MATTERS = 0.01  # share of a sum of squares on held-out data that a better prediction saves
Samples = Float[np.ndarray, "segment sample"]


@dataclass(frozen=True, eq=False)
class Prediction:
    """Segments as they were predicted by a fit of the others."""

    angle: Annotated[Samples, "rad"]
    counted: Bool[np.ndarray, "segment sample"]  # which samples were held out
    rmse: Annotated[Float[np.ndarray, " segment"], "rad"]
    squares: Annotated[Float[np.ndarray, " fold"], "1"]  # of both channels over their noise

    @property
    def total(self) -> float:
        """rad, over all segments."""
        weights = self.counted.sum(axis=1)
        return float(np.sqrt(weights @ self.rmse**2 / weights.sum()))


@dataclass(frozen=True, eq=False)
class Proof:
    """The same prediction without and with what was found."""

    before: Prediction
    after: Prediction
    time: Annotated[Samples, "s"]
    angle: Annotated[Samples, "rad"]  # measured
    noise_floor: Annotated[float, "rad"]
    in_time: bool  # a single segment, its quarters predicted from each other

    @property
    def better(self) -> int:
        """Segments, or quarters of a single one, that are predicted better than before."""
        return int(np.sum(self.after.squares < self.before.squares))

    @property
    def holds(self) -> bool:
        """Is most of it predicted better, and all of it together?"""
        return improves(self.before, self.after)


def improves(before: Prediction, after: Prediction) -> bool:
    """Is most of it predicted better, and all of it together, by more than what is no matter?"""
    better = np.sum(after.squares < before.squares)
    gained = after.squares.sum() < (1 - MATTERS) * before.squares.sum()
    return bool(2 * better > after.squares.size and gained)
