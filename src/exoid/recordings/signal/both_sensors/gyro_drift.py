"""A gyro's zero that wanders, told by the encoder without any leg model.

Over a window the mean of the gyro is its zero plus the angle's change. A wrong scale adds what goes
with that change, a late gyro with that of the rate and, by half the square of its delay, of the
acceleration, a magnet off the encoder's centre with those of the sines of the angle. What is left
and changes slowly is the zero's drift.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from exoid.recordings.chi_square import chance_above
from exoid.recordings.measured.samples import Samples
from exoid.recordings.signal.local_line import local_line

WINDOW = 0.5  # s; half a swing: short enough to separate motion and drift
# By data sheets: of scale [1], delay [s], half its square [s^2], and what a magnet off its centre
# adds [rad].
ERRORS = np.array([0.1, 0.02, 2e-4, 0.02, 0.02, 0.01, 0.01])
STEADY = 0.1  # s, over which an acceleration is told by the rate
KNOT = 2.5  # s between which the zero changes evenly
FALSE = 1e-4  # chance that noise alone shows a drift
EXPLAINED = 2.0  # mean square over its error, that a drift may leave: else the mismatch is another
MATTERS = 0.1  # of the gyro's noise, of a drift's root mean square
FEWEST = 3  # samples in a window

Signals = list[Samples]


@dataclass(frozen=True, eq=False)
class Windows:
    """Windows of one segment: the gyro less the encoder, its error, and what motion may add."""

    time: Samples  # s, their middles
    excess: Samples  # rad/s
    error: Samples  # rad/s
    motion: NDArray[np.float64]  # (window, error): what other errors of the sensors may add


def gyro_drift(
    times: Signals, angles: Signals, rates: Signals, noise: tuple[float, float]
) -> Signals | None:
    """The gyro's zero less its mean over the recording [rad/s] at every sample of every segment;
    None where it is steady. `noise` is that of an angle [rad] and of a rate [rad/s].
    """
    parts = [windows(*each, noise) for each in zip(times, angles, rates, strict=True)]
    hats = [knots(part.time) for part in parts]
    count = sum(hat.shape[1] for hat in hats)
    size = sum(part.time.size for part in parts)
    if count < 2 or size < count + FEWEST:
        return None
    told = [np.column_stack([p.motion, p.excess]) / p.error[:, None] for p in parts]
    shapes = [hat / part.error[:, None] for hat, part in zip(hats, parts, strict=True)]
    weight = np.concatenate([1 / part.error for part in parts])
    steady = beside(weight[:, None], np.concatenate(told))
    wandering = np.concatenate([beside(*each) for each in zip(shapes, told, strict=True)])
    motion, left = explained_by(wandering)
    gain = explained_by(steady)[1] - left
    zeros = [
        np.linalg.lstsq(shape, each[:, -1] - each[:, :-1] @ motion, rcond=None)[0]
        for shape, each in zip(shapes, told, strict=True)
    ]
    together = np.concatenate(zeros)
    explained = left < EXPLAINED * (size - count)
    matters = np.std(together) >= MATTERS * noise[1]
    if chance_above(count - 1, gain) > FALSE or not matters or not explained:
        return None
    return [
        np.interp(time, places(part.time), own - together.mean())
        for time, part, own in zip(times, parts, zeros, strict=True)
    ]


def windows(time: Samples, angle: Samples, rate: Samples, noise: tuple[float, float]) -> Windows:
    """Neighbouring windows between known samples of both channels."""
    known = ~(np.isnan(angle) | np.isnan(rate))
    time, angle, rate = time[known], angle[known], rate[known]
    if not time.size:  # two loggers, whose samples never fall on one time
        return Windows(time, time, time, np.zeros((0, ERRORS.size)))
    count = max(int((time[-1] - time[0]) / WINDOW), 1)
    edges = np.unique(np.searchsorted(time, np.linspace(time[0], time[-1], count + 1)))
    area = np.concatenate([[0.0], np.cumsum(np.diff(time) * (rate[1:] + rate[:-1]) / 2)])
    edges = edges[np.append(True, np.diff(edges) >= FEWEST)]
    first, last = edges[:-1], edges[1:]
    length = time[last] - time[first]
    sines = [wave(turns * angle) for turns in (1, 2) for wave in (np.sin, np.cos)]
    slope = local_line(time, rate, STEADY)[1]
    change, *others = ((each[last] - each[first]) / length for each in (angle, rate, slope, *sines))
    of_angle, of_rate = noise
    error = np.sqrt(2 * (of_angle / length) ** 2 + of_rate**2 / (last - first))
    return Windows(
        time=(time[first] + time[last]) / 2,
        excess=(area[last] - area[first]) / length - change,
        error=error,
        motion=np.stack([change, *others], axis=1),
    )


def places(time: Samples) -> Samples:
    """Where the zero of a segment is told [s]."""
    if not time.size:
        return np.zeros(1)
    count = int((time[-1] - time[0]) / KNOT) + 1
    return np.linspace(time[0], time[-1], count) if count > 1 else np.array([time.mean()])


def knots(time: Samples) -> NDArray[np.float64]:
    """The share of every knot in every window: linear between knots."""
    at = places(time)
    return np.stack([np.interp(time, at, row) for row in np.eye(at.size)], axis=1)


def beside(shape: NDArray[np.float64], columns: NDArray[np.float64]) -> NDArray[np.float64]:
    """What no combination of the columns of `shape` explains of others.

    A zero belongs to one segment: taken out of each before all are put together, hundreds of
    segments cost no more than each by itself.
    """
    basis, size, _ = np.linalg.svd(shape, full_matrices=False)
    basis = basis[:, size > np.finfo(float).eps * max(shape.shape) * size.max(initial=0.0)]
    return columns - basis @ (basis.T @ columns)


def explained_by(columns: NDArray[np.float64]) -> tuple[NDArray[np.floating], float]:
    """How much of each error of the sensors the last column shows, and the sum of squares that is
    left. With a row for every error, so that none is implausible.
    """
    rows = np.column_stack([np.diag(1 / ERRORS), np.zeros(ERRORS.size)])
    columns = np.concatenate([columns, rows])
    found = np.linalg.lstsq(columns[:, :-1], columns[:, -1], rcond=None)[0]
    return found, float(np.sum((columns[:, -1] - columns[:, :-1] @ found) ** 2))
