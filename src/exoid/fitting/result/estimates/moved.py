"""How far a fit may have moved by what is no unknown of it, and its numbers with it."""

from dataclasses import dataclass

import numpy as np

from exoid.fitting.result.estimates.estimate import Estimate


@dataclass(frozen=True, eq=False)
class Moved:
    """Steps of the coordinates, (coordinate, step) by cause, each of one standard deviation."""

    by: dict[str, np.ndarray]

    def widen(self, each: Estimate, gradient: np.ndarray) -> Estimate:
        """An estimate of this gradient, its error with how far it may be off."""
        for cause, steps in self.by.items():
            each = each.widened(float(np.linalg.norm(gradient @ steps)), cause=cause)
        return each

    def off(self, gradient: np.ndarray) -> float:
        """How far a quantity of this gradient may be off."""
        return float(np.linalg.norm([np.linalg.norm(gradient @ each) for each in self.by.values()]))
