"""A candidate at its best."""

from dataclasses import dataclass
from typing import Any

from exoid.mismatch.screen.hypothesis import Hypothesis, Products

DAMPING = 1e-3  # of the first step, relative to the curvature


@dataclass(frozen=True, eq=False)
class Optimum:
    """A candidate at its best, and the derivatives there."""

    candidate: Hypothesis
    products: Products
    course: Any  # pinned: the MeasuredMotion along which; free: what the sensors would show
    damping: float = DAMPING
    resting: bool = False

    @property
    def square(self) -> float:
        return self.products.square
