"""Inner products that stand for a segment where its disturbance is asked for, and its causes."""

from dataclasses import dataclass
from typing import Literal

import numpy as np

Cause = Literal["torque", "encoder"]
CAUSES: tuple[Cause, ...] = ("torque", "encoder")
UNIT: dict[Cause, float] = {"torque": 1.0, "encoder": 1e-2}  # rad/s^2, rad: of u in its gram


@dataclass(frozen=True, eq=False)
class Gram:
    """Sensitivities A and residual r of one segment, and the effect S of what may disturb it.

    The triangle R of (S, A, r) = Q R has all inner products of their columns, and keeps what is
    left of A and r outside of S to its own digits, where S'S, S'A and A'A would lose them.
    """

    place: np.ndarray  # coordinates of the segment's unknowns
    effect: np.ndarray  # of S alone, (row, node)
    inside: np.ndarray  # of (A, r) along S, (row, unknown and residual)
    outside: np.ndarray  # of what no disturbance makes
    nodes: np.ndarray  # s, times of the nodes

    @property
    def fitted(self) -> np.ndarray:
        """(A, r)'(A, r)."""
        return self.inside.T @ self.inside + self.outside.T @ self.outside


Grams = dict[Cause, Gram]  # of one segment
