"""What a device writes down of a session."""

from dataclasses import dataclass

import numpy as np

from .case import Case
from .devices import GYRO_STEP, rounded, sample_times
from .kalman import filtered
from .session import Session
from .troubles import LOST, disturb

Columns = dict[str, np.ndarray]


@dataclass(frozen=True)
class Segment:
    """One segment's rows; `time` is the session's true time, nan is an empty cell."""

    time: np.ndarray  # s
    columns: Columns

    def recorded(self, time, clock: float):
        """The time column's value at a true time."""
        return (time - self.time[0]) * (1 + clock)


def measure(case: Case, session: Session, rng: np.random.Generator) -> tuple[Segment, ...]:
    """Every window as a segment."""
    device, errors, motion = case.device, case.errors, session.motion
    time = sample_times(device, 0.0, float(motion.time[-1]), rng)
    noise = disturb(case.trouble, device, time, rng)
    count = 2 * np.pi / device.counts if device.counts else 0.0
    shown = errors.angle(motion.angle_at(time)) + noise.angle
    columns = {"raw_angle_rad": rounded(shown, count)}
    if device.velocity_noise is not None:
        past = motion.rate_at(np.maximum(time - errors.delay, 0.0))
        rate = errors.velocity(past) + noise.velocity
        columns["raw_velocity_rad_s"] = rounded(rate, GYRO_STEP)
    if device.kind == "node":
        state = filtered(time, *columns.values())
        names = ("angle_rad", "velocity_rad_s", "acceleration_rad_s2")
        columns = dict(zip(names, state.T, strict=True)) | columns
    keep = np.ones(time.size, bool)
    if case.trouble == "lost" and (device.kind == "node" or rng.random() < 0.5):
        keep = noise.kept
    elif case.trouble == "lost":
        columns = {name: holed(each, rng) for name, each in columns.items()}
    cut = (keep & (begin <= time) & (time <= end) for begin, end in session.windows)
    return tuple(Segment(time[k], {n: c[k] for n, c in columns.items()}) for k in cut)


def holed(column: np.ndarray, rng: np.random.Generator) -> np.ndarray:
    """With empty cells, each channel its own."""
    return np.where(rng.random(column.size) < LOST, np.nan, column)
