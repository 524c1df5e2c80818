"""How well one segment is fitted, and several together."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Annotated

import numpy as np
from jaxtyping import Float

from exoid.fitting.result.conditions import Conditions
from exoid.fitting.result.estimates.estimate import Estimate

Curve = Float[np.ndarray, " sample"]


@dataclass(frozen=True, eq=False)
class SegmentFit:
    """Measured and simulated motion of one segment, at the samples that were fitted.

    nan is what was not measured or does not count, and where the simulation has ended.
    """

    name: str
    kind: str
    period: Annotated[float | None, "s"]
    torque_amplitude: Estimate | None  # None where no voluntary torque acts
    added_mass: Annotated[float, "kg"]
    angle_rmse: Annotated[float, "rad"]
    velocity_rmse: Annotated[float | None, "rad/s"]
    angle_noise: Annotated[float, "rad"]
    velocity_noise: Annotated[float | None, "rad/s"]
    time: Annotated[Curve, "s"]  # from the first fitted sample
    angle: Annotated[Curve, "rad"]  # measured
    angular_velocity: Annotated[Curve | None, "rad/s"]  # measured
    simulated_angle: Annotated[Curve, "rad"]
    simulated_velocity: Annotated[Curve, "rad/s"]
    begins: Annotated[float, "s"] = 0.0  # its first fitted sample on the clock of the recording
    conditions: Conditions | None = None  # to simulate it again; older files have none
    left_out: Annotated[float, "s"] = 0.0  # behind its release: what kept the leg back there
    caught: Annotated[float | None, "s"] = None  # on that clock: a hand, and nothing behind counts

    def __repr__(self) -> str:
        return f"<SegmentFit {self.name}: {self.kind}, {self.time.size} samples>"


def pooled(segments: Sequence[SegmentFit], of: Callable[[SegmentFit], float]) -> float:
    """Root of the mean square over the samples of the segments."""
    each = [(of(segment), segment.time.size) for segment in segments]
    return float(np.sqrt(sum(v * v * n for v, n in each) / sum(n for _, n in each)))
