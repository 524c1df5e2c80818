"""Inner products that stand for a segment where its disturbance is asked for, and its causes."""

from dataclasses import dataclass
from typing import Literal

import numpy as np

Cause = Literal["torque", "encoder"]
CAUSES: tuple[Cause, ...] = ("torque", "encoder")
UNIT: dict[Cause, float] = {"torque": 1.0, "encoder": 1e-2}  # rad/s^2, rad: of u in its gram


@dataclass(frozen=True, eq=False)
class Gram:
    """Inner products of one segment: sensitivities A and residual r, and the process' effect S."""

    place: np.ndarray  # coordinates of the segment's unknowns
    fitted: np.ndarray  # (A, r)'(A, r)
    cross: np.ndarray  # S'(A, r)
    process: np.ndarray  # S'S
    nodes: np.ndarray  # s, times of the nodes


Grams = dict[Cause, Gram]  # of one segment
