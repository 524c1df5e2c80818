"""The smallest standard deviations of the ratios that a recording allows, by Fisher information.

Cramer-Rao for white noise of known size: every drop's start is unknown, the zero of the angle is
known to 1 degree, the leg obeys Eq. 9. Sensitivities are central differences of the simulation.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from .leg import Physics
from .motion import swing_freely

ZERO_KNOWN = np.radians(1.0)  # rad, one standard deviation
TICK = 2e-3  # s, of the simulation: order four leaves 1e-8 rad
PROBE = 1e-4  # of the unknowns, relative or in rad and rad/s
RATIOS = ("gravity_over_inertia", "stiffness_over_inertia", "damping_over_inertia")
ROUNDS = 8  # of Gauss and Newton, at most
ENOUGH = 1e-3  # of the sum of squares: less gain ends them


@dataclass(frozen=True)
class Swing:
    """Samples of one free swing: of the angle at `time`, of the rate at `gyro_time` or none."""

    time: np.ndarray  # s
    angle: np.ndarray  # rad
    gyro_time: np.ndarray  # s
    velocity: np.ndarray  # rad/s
    start: tuple[float, float]  # rad, rad/s, at the first of all samples

    @property
    def origin(self) -> float:
        firsts = [times[0] for times in (self.time, self.gyro_time) if times.size]
        return min(firsts)


@dataclass(frozen=True)
class Levels:
    """White noise; without a gyro its level is of no consequence."""

    angle: float  # rad
    velocity: float  # rad/s


def simulate(ratios: np.ndarray, zero: float, start: np.ndarray, swing: Swing) -> np.ndarray:
    """Both channels' readings in a row; infinite where the motion runs away."""
    gravity, stiffness, damping = ratios
    times = np.concatenate([swing.time, swing.gyro_time]) - swing.origin
    physics = Physics(1.0, gravity, stiffness, damping)
    motion = swing_freely(physics, (start[0], start[1]), float(times.max()), TICK)
    if not np.isfinite(motion.acceleration).all():
        return np.full(times.size, np.inf)
    shown = motion.angle_at(times[: swing.time.size]) + zero
    return np.concatenate([shown, motion.rate_at(times[swing.time.size :])])


def weigh(values: np.ndarray, swing: Swing, levels: Levels) -> np.ndarray:
    sizes = (levels.angle, levels.velocity)
    counts = (swing.time.size, swing.gyro_time.size)
    return values / np.repeat(sizes, counts)


def sensitivity(ratios, zero, start, swing: Swing, levels: Levels) -> np.ndarray:
    """Columns: three ratios, the zero, angle and rate at the start; in noise levels."""
    point = np.array([*ratios, zero, *start])
    columns = []
    for k in range(point.size):
        step = np.zeros(point.size)
        step[k] = PROBE * max(point[k], 1.0) if k < 3 else PROBE
        up, down = (simulate(x[:3], x[3], x[4:], swing) for x in (point + step, point - step))
        columns.append(weigh(up - down, swing, levels) / (2 * step[k]))
    return np.stack(columns, axis=1)


def whole(ratios, zero, starts, swings: Sequence[Swing], levels: Levels) -> np.ndarray:
    """All swings' sensitivities, each with its own start, and the prior of the zero as a row."""
    blocks = []
    for k, (swing, start) in enumerate(zip(swings, starts, strict=True)):
        found = sensitivity(ratios, zero, start, swing, levels)
        block = np.zeros((found.shape[0], 4 + 2 * len(swings)))
        block[:, :4], block[:, 4 + 2 * k : 6 + 2 * k] = found[:, :4], found[:, 4:]
        blocks.append(block)
    prior = np.eye(1, 4 + 2 * len(swings), 3) / ZERO_KNOWN
    return np.concatenate([*blocks, prior])


def remaining(ratios, zero, starts, swings: Sequence[Swing], levels: Levels) -> np.ndarray:
    """Measured less simulated, in noise levels; the last is the zero's prior."""
    parts = [
        weigh(np.concatenate([s.angle, s.velocity]) - simulate(ratios, zero, start, s), s, levels)
        for s, start in zip(swings, starts, strict=True)
    ]
    return np.concatenate([*parts, [-zero / ZERO_KNOWN]])


def smallest_errors(
    ratios: dict[str, float], swings: Sequence[Swing], levels: Levels
) -> dict[str, float]:
    """Of the three ratios, 1/s^2 and 1/s."""
    starts = [np.array(each.start) for each in swings]
    jacobian = whole(np.array([ratios[k] for k in RATIOS]), 0.0, starts, swings, levels)
    scale = np.linalg.norm(jacobian, axis=0)
    covariance = np.linalg.inv((jacobian / scale).T @ (jacobian / scale))
    deviation = np.sqrt(np.diag(covariance)) / scale
    return dict(zip(RATIOS, deviation.tolist(), strict=False))


@dataclass(frozen=True)
class Refit:
    """Eq. 9 fitted to swings, and what is left over."""

    ratios: dict[str, float]
    left: float  # in noise levels: root of the sum of squares


def refit(ratios: dict[str, float], swings: Sequence[Swing], levels: Levels) -> Refit:
    """The best of Eq. 9 near the truth, by Gauss and Newton with halved steps."""
    point = np.array([*(ratios[k] for k in RATIOS), 0.0, *(x for s in swings for x in s.start)])

    def split(x):
        return x[:3], x[3], x[4:].reshape(-1, 2)

    rest = remaining(*split(point), swings, levels)
    for _ in range(ROUNDS):
        change = np.linalg.lstsq(whole(*split(point), swings, levels), rest, rcond=None)[0]
        for share in (1.0, 0.5, 0.25, 0.1):
            trial = remaining(*split(point + share * change), swings, levels)
            if trial @ trial < rest @ rest:
                break
        else:
            break
        gain = rest @ rest - trial @ trial
        point, rest = point + share * change, trial
        if gain < ENOUGH * (1 + rest @ rest):
            break
    found = dict(zip(RATIOS, point[:3].tolist(), strict=False))
    return Refit(found, float(np.sqrt(rest @ rest)))
