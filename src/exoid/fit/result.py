"""What a fit found: values with their errors and reasons, not bare numbers."""

from dataclasses import dataclass, field

import numpy as np
from jaxtyping import Float

from exoid.fit.uncertainty import Source


@dataclass(frozen=True)
class Estimate:
    """A quantity as the tables print it. `value` is None where nothing determines it."""

    symbol: str
    title: str
    unit: str
    value: float | None
    standard_error: float | None
    expected: float | None = None
    expected_deviation: float | None = None
    lower: float | None = None
    upper: float | None = None
    determined_by: Source | None = None
    reason: str | None = None  # why there is no value, or no error


@dataclass(frozen=True, eq=False)
class SegmentFit:
    """Measured and simulated motion of one segment, at the samples that were fitted."""

    name: str
    kind: str
    period: float | None  # s
    torque_amplitude: Estimate | None  # None where no voluntary torque acts
    added_mass: float  # kg
    angle_rmse: float  # rad
    velocity_rmse: float | None  # rad/s
    angle_noise: float  # rad
    velocity_noise: float | None  # rad/s
    time: Float[np.ndarray, " sample"]  # s, from the first fitted sample
    angle: Float[np.ndarray, " sample"]  # rad, measured
    angular_velocity: Float[np.ndarray, " sample"] | None  # rad/s, measured
    simulated_angle: Float[np.ndarray, " sample"]  # rad
    simulated_velocity: Float[np.ndarray, " sample"]  # rad/s


@dataclass(frozen=True, eq=False)
class MultistartReport:
    """Where the starts ended. `members` are sets that fit as well as the best, one per start."""

    starts: int
    succeeded: int
    at_best: int
    loss: Float[np.ndarray, " start"]  # of the data alone, inf where a start failed
    failures: dict[str, int]  # reason: number of starts
    family: dict[str, tuple[float, float]]  # parameter: its range at the same ratios
    members: dict[str, Float[np.ndarray, " member"]]
    distinct: int  # minima found


@dataclass(frozen=True, eq=False)
class FitResult:
    """The chosen parameters and ratios, how well they fit, and what else fits as well."""

    parameters: dict[str, Estimate]  # mass, inertia, com_distance, damping, stiffness (, torque)
    ratios: dict[str, Estimate]
    segments: list[SegmentFit]
    multistart: MultistartReport
    loss: float  # half the sum of squares of data and prior, in units of noise
    noise_scale: float  # by which standard errors were widened beyond sensor noise
    torque_frequency: str | None  # the reading of Eq. 4 that fits better, None without cycles
    other_reading_rmse: float | None  # rad, of the reading that fits worse, where both were tried
    prior: str
    notes: list[str] = field(default_factory=list)

    @property
    def samples(self) -> int:
        return sum(each.time.size for each in self.segments)

    @property
    def angle_rmse(self) -> float:
        """rad, over all segments."""
        return pooled([(each.angle_rmse, each.time.size) for each in self.segments])

    @property
    def velocity_rmse(self) -> float | None:
        """rad/s, over the segments that have a gyro."""
        known = [
            (each.velocity_rmse, each.time.size)
            for each in self.segments
            if each.velocity_rmse is not None
        ]
        return pooled(known) if known else None

    @property
    def angle_noise(self) -> float:
        """rad, the floor that no model can go below."""
        return pooled([(each.angle_noise, each.time.size) for each in self.segments])


def pooled(each: list[tuple[float, int]]) -> float:
    """Root of the mean square over samples."""
    return float(np.sqrt(sum(v * v * n for v, n in each) / sum(n for _, n in each)))
