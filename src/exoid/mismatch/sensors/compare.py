"""Encoder against gyro by least squares: all errors that are asked for, in one joint estimate."""

from dataclasses import dataclass, field

import numpy as np

from exoid.mismatch.sensors.faults import SKEW, Fault
from exoid.mismatch.sensors.smooth import (
    JERKS,
    Reference,
    Samples,
    Smoother,
    reweighed,
    smooth,
    smoothed,
    smoother_of,
)

DRIFTS = (0.0, 2e-3, 1e-2)  # rad/s, of a gyro's bias, to choose from
ROUNDS = 3  # a late gyro is shifted by what the last round found
FLAT = 1e-10  # relative curvature of what these segments do not tell
Measured = tuple[np.ndarray, np.ndarray, np.ndarray]  # of a segment: time, data, weights


@dataclass(frozen=True, eq=False)
class Compared:
    """The errors of sensors, and the quadratic form of what they leave: (r - x)'N(r - x)."""

    faults: tuple[Fault, ...]
    values: np.ndarray  # of all parameters, one fault after the other
    normal: np.ndarray
    left: float  # sum of squares over the noise
    samples: int  # of both channels
    motions: list[Reference] = field(repr=False)

    @property
    def misfit(self) -> float:
        """What is left, a sample: 1 where it is noise, for the jerk is told by its own rows."""
        return self.left / self.samples

    @property
    def covariance(self) -> np.ndarray:
        """By the noise alone."""
        return inverse(self.normal)

    def places(self, some: tuple[Fault, ...]) -> np.ndarray:
        """Which of the parameters are those of some faults."""
        whose = np.repeat(np.arange(len(self.faults)), [one.parameters for one in self.faults])
        return np.flatnonzero(np.isin(whose, [self.faults.index(one) for one in some]))

    def of(self, one: Fault) -> np.ndarray:
        return self.values[self.places((one,))]


def inverse(normal: np.ndarray) -> np.ndarray:
    """Of a matrix with units; 0 for what it says nothing of."""
    size = np.sqrt(np.diag(normal))
    unit = np.where(size > 0, size, 1.0)
    units = np.outer(unit, unit)
    return np.linalg.pinv(normal / units, rcond=FLAT, hermitian=True) / units


def compare(
    segments: list[Measured], struck: list[np.ndarray], faults: tuple[Fault, ...]
) -> Compared:
    """The errors of encoder and gyro against each other, over all segments; steps that are `struck`
    tell nothing of them.
    """
    values = np.zeros(sum(one.parameters for one in faults))
    motions = [
        smooth(time, data, weights * [1.0, 0.0], own)
        for (time, data, weights), own in zip(segments, struck, strict=True)
    ]
    found = None
    for _ in range(ROUNDS):
        cleaned = with_right_gyros(segments, motions, faults, values)
        found, smoothers = in_one_round(cleaned, motions, faults, values, struck)
        values = found.values
        cleaned = with_right_gyros(segments, motions, faults, values)
        motions = [  # a gyro that is moved by a row leaves one at an end without
            smoothed(reweighed(one, weights), data)
            for one, (_, data, weights) in zip(smoothers, cleaned, strict=True)
        ]
    assert found is not None  # there are rounds
    return Compared(faults, values, found.normal, found.left, found.samples, motions)


def with_right_gyros(
    segments: list[Measured],
    motions: list[Reference],
    faults: tuple[Fault, ...],
    values: np.ndarray,
) -> list[Measured]:
    """The data as gyros without these errors would have shown them."""
    return [
        right(one, motion, faults, values) for one, motion in zip(segments, motions, strict=True)
    ]


def skew_of(faults: tuple[Fault, ...], values: np.ndarray) -> float:
    """By how much the gyro is late [s]."""
    own = [one for fault, one in zip(faults, split(faults, values), strict=True) if fault is SKEW]
    return float(own[0][0]) if own else 0.0


def right(
    measured: Measured, motion: Reference, faults: tuple[Fault, ...], values: np.ndarray
) -> Measured:
    """One segment: what a late gyro shows stands in the row about the instant that it shows, so
    that the motion, which the gyro itself tells, is asked for no more than the rest of the way.
    """
    time, data, weights = measured
    wrong = motion.angular_velocity
    for one, own in zip(faults, split(faults, values), strict=True):
        if one is not SKEW:
            wrong = wrong + one.columns(motion) @ own
    skew = skew_of(faults, values)
    source, row = moved(time, np.flatnonzero(weights[:, 1]), skew)
    error = np.interp(time[source] - skew, time, wrong) - motion.angular_velocity[row]
    gyro = np.zeros((2, time.size))
    gyro[:, row] = data[source, 1] - error, weights[source, 1]
    return time, np.stack([data[:, 0], gyro[0]], axis=1), np.stack([weights[:, 0], gyro[1]], axis=1)


def moved(time: Samples, rows: np.ndarray, skew: float) -> tuple[np.ndarray, np.ndarray]:
    """Of the gyro's samples in these rows, those that show an instant of the record, and the rows,
    as many of them earlier as it is late, to which they go.
    """
    if rows.size < 2:
        return rows, rows
    by = int(np.rint(skew * (rows.size - 1) / (time[rows[-1]] - time[rows[0]])))
    place = np.arange(rows.size) - by
    inside = (place >= 0) & (place < rows.size)
    source, row = rows[inside], rows[place[inside]]
    shown = time[source] - skew
    near = (row == source) | (np.abs(shown - time[row]) < abs(skew))  # not over a hole
    kept = near & (shown >= time[0]) & (shown <= time[-1])
    return source[kept], row[kept]


def split(faults: tuple[Fault, ...], values: np.ndarray) -> list[np.ndarray]:
    """The values of each."""
    return np.split(values, np.cumsum([one.parameters for one in faults])[:-1])


def in_one_round(
    cleaned: list[Measured],
    motions: list[Reference],
    faults: tuple[Fault, ...],
    so_far: np.ndarray,
    struck: list[np.ndarray],
) -> tuple[Compared, list[Smoother]]:
    """A Gauss-Newton step, with the jerk and the gyro's drift that make the data most likely."""
    best = None
    for jerk in JERKS:
        made = [
            smoother_of(time, weights, float(jerk), own)
            for (time, _, weights), own in zip(cleaned, struck, strict=True)
        ]
        smoothers = [each for each in made if each is not None]
        if len(smoothers) < len(made):
            continue
        tables = products(cleaned, motions, smoothers, faults)
        scatter = sum(each.log_scatter for each in smoothers)
        for drift in DRIFTS:
            table, drifting = without_drift(tables, drift)
            change = inverse(table[1:, 1:]) @ table[1:, 0]
            left = float(table[0, 0] - table[1:, 0] @ change)
            likelihood = scatter + drifting - left / 2
            if best is None or likelihood > best[0]:
                best = (likelihood, change, table[1:, 1:], left, smoothers)
    assert best is not None  # there are jerks to try
    _, change, normal, left, smoothers = best
    samples = sum(int((weights > 0).sum()) for _, _, weights in cleaned)
    return Compared(faults, so_far + change, normal, left, samples, motions), smoothers


def products(
    cleaned: list[Measured],
    motions: list[Reference],
    smoothers: list[Smoother],
    faults: tuple[Fault, ...],
) -> list[np.ndarray]:
    """(data, columns, drift)'(data, columns, drift) of what no motion follows, of each segment."""
    tables = []
    for (time, data, _), motion, smoother in zip(cleaned, motions, smoothers, strict=True):
        slope = np.interp(time, time[[0, -1]], [-1.0, 1.0])
        drift = np.stack([np.ones_like(slope), slope], axis=1)
        rates = np.concatenate(
            [data[:, 1:], *(one.columns(motion) for one in faults), drift], axis=1
        )
        angles = np.concatenate([data[:, :1], np.zeros_like(rates[:, 1:])], axis=1)
        rows = smoother.left(np.stack([angles, rates], axis=1))
        tables.append(rows.T @ rows)
    return tables


def without_drift(tables: list[np.ndarray], drift: float) -> tuple[np.ndarray, float]:
    """The sum of all segments' (data, columns)'(data, columns), where the gyro's bias scatters by
    `drift` [rad/s] from one to the next and within each, and the log of how likely it is.
    """
    total, likely = 0.0, 0.0
    for table in tables:
        told, cross = table[:-2, :-2], drift * table[:-2, -2:]
        own = np.eye(2) + drift**2 * table[-2:, -2:]
        total = total + told - cross @ np.linalg.solve(own, cross.T)
        likely -= float(np.linalg.slogdet(own).logabsdet) / 2
    return np.asarray(total), likely
