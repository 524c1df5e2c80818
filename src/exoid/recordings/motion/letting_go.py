"""When a hand let go of a leg, by the likelihood of every instant and duration.

Held at phi_s until t0; over w seconds the hand's torque fades evenly; then the leg is free:

    phi = phi_s + a y(t - t0, w) + b x^3 + c x^4 + e x^5,   x = t - t0 - w / 2 > 0

with y of `fall` for one of a few legs, and small b, c, e for what this leg does otherwise.
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from exoid.recordings.motion.fall import Swing, falling
from exoid.recordings.motion.signal import Signal
from exoid.recordings.motion.thresholds import (
    COARSE,
    FALL,
    GONE,
    GREATEST,
    LEGS,
    MARGIN,
    ODD,
    SHAPE,
    TAIL,
    TRIED,
    WINDOWS,
)
from exoid.recordings.samples import Samples

POWERS = (3, 4, 5)

Table = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class LettingGo:
    """How a hold ended. Times in s on the segment's clock."""

    begin: float  # when the hand began to let go, at the latest
    release: float  # from when on a leg that fell from rest would be as fast
    error: float  # of `release`, standard
    gone: float  # when the hand surely was off the leg
    misfit: float  # chi-square a sample
    chi_square: float


@dataclass(frozen=True, eq=False)
class ReleaseWindow:
    """The samples that judge a release, and how large a fall they show."""

    signal: Signal
    pull: float  # rad/s^2, about the first acceleration
    room: tuple[float, ...] = ODD  # rad, of b, c, e
    legs: tuple[Swing, ...] = tuple(Swing(*each) for each in LEGS)


def let_go(case: ReleaseWindow, low: float, high: float) -> LettingGo:
    """The release between `low` and `high` s: first roughly and of many legs, then finely."""
    rough = np.arange(low, high + COARSE, COARSE)
    widths = WINDOWS[:: WINDOWS.size // 2]
    every = np.stack([table_of(case, leg, rough, widths) for leg in case.legs])
    leg = case.legs[int(np.argmin(every.min(axis=(1, 2))))]
    scale = spread(case, every)
    weight = np.exp(-(every.min(axis=0) - every.min()) / 2 / scale).sum(axis=0)
    kept = rough[weight > weight.max() * 1e-4]
    step = np.clip((kept[-1] - kept[0]) / 60, *TRIED)
    tried = np.arange(max(low, kept[0] - COARSE), min(high, kept[-1] + COARSE) + step, step)
    square = table_of(case, leg, tried, WINDOWS)
    found = summed(tried, square, spread(case, square), case)
    return replace(found, error=max(found.error, wobble(rough, widths, every, scale)))


def wobble(tried: Samples, widths: Samples, square: Table, scale: float) -> float:
    """The scatter of the release over all legs [s], where that is more than of the best leg."""
    weight = np.exp(-(square - square.min()) / 2 / scale)
    effective = np.broadcast_to(tried[None, :] + widths[:, None] / 2, square.shape)
    mean = np.average(effective, weights=weight)
    return float(np.sqrt(np.average((effective - mean) ** 2, weights=weight)))


def table_of(case: ReleaseWindow, leg: Swing, tried: Samples, widths: Samples) -> Table:
    """Chi-square of every duration and instant."""
    return np.stack([misfits(case, leg, tried, width) for width in widths.tolist()])


def spread(case: ReleaseWindow, square: Table) -> float:
    """By how much the model is rougher than the noise."""
    return max(1.0, float(square.min()) / max(samples_within(case) - 8, 1))


def summed(tried: Samples, square: Table, scale: float, case: ReleaseWindow) -> LettingGo:
    """Mean, error and bounds by the likelihood of all that was tried."""
    best = float(square.min())
    weight = np.exp(-(square - best) / 2 / scale)
    weight /= weight.sum()
    effective = tried[None, :] + WINDOWS[:, None] / 2
    release = float(np.sum(weight * effective))
    error = float(np.sqrt(np.sum(weight * (effective - release) ** 2) + SHAPE**2))
    begin = quantile(np.broadcast_to(tried, weight.shape), weight, 1 - GONE)
    gone = quantile(tried[None, :] + (1 + TAIL) * WINDOWS[:, None], weight, GONE) + MARGIN
    return LettingGo(begin, release, error, gone, best / max(samples_within(case), 1), best)


def quantile(values: Table, weight: Table, share: float) -> float:
    order = np.argsort(values, axis=None)
    total = np.cumsum(weight.ravel()[order])
    return float(values.ravel()[order][min(np.searchsorted(total, share), total.size - 1)])


def samples_within(case: ReleaseWindow) -> int:
    each = (case.signal.angle, case.signal.velocity)
    return sum(int(np.sum(~np.isnan(one))) for one in each if one is not None)


def misfits(case: ReleaseWindow, leg: Swing, tried: Samples, width: float) -> Samples:
    """Chi-square of every tried instant, its amplitudes at their best."""
    since = case.signal.time[None, :] - tried[:, None]
    table, data = rows(case, [columns(since, leg, width, order) for order in (0, 1)])
    believed = np.zeros((tried.size, len(POWERS), table.shape[2]))
    room = np.array(case.room) * np.clip(case.pull / GREATEST, 0.02, 1.0)
    believed[:, range(len(POWERS)), range(1, 1 + len(POWERS))] = 1 / room
    table = np.concatenate([table, believed], axis=1)
    return least_squares(table, np.concatenate([data, np.zeros(believed.shape[:2])], axis=1))


def begun_free(case: ReleaseWindow) -> float:
    """Chi-square of a leg that is free from the first sample on, at rest or in motion."""
    since = case.signal.time[None, :] - case.signal.time[0]

    def motion(leg: Swing, order: int) -> Table:
        each = [falling(since, 0.0, leg, order), falling(since, 0.0, leg, order + 1)]
        return beside_levels(each, order)

    each = [rows(case, [motion(leg, 0), motion(leg, 1)]) for leg in case.legs]
    return min(float(least_squares(*one)[0]) for one in each)


def rows(case: ReleaseWindow, tables: list[Table]) -> tuple[Table, Table]:
    """Columns and data of angle and gyro, where they were measured, over their noise."""
    signal, found, data = case.signal, [], []
    channels = ((signal.angle, signal.angle_noise), (signal.velocity, signal.velocity_noise))
    for table, (samples, noise) in zip(tables, channels, strict=True):
        if samples is not None:
            seen = ~np.isnan(samples)
            found.append(table[:, seen] / noise)
            data.append(np.broadcast_to(samples[seen] / noise, found[-1].shape[:2]))
    return np.concatenate(found, axis=1), np.concatenate(data, axis=1)


def least_squares(table: Table, data: Table) -> Samples:
    """The sum of squares that is left of every row of `data` (try, sample)."""
    size = np.maximum(np.sqrt((table**2).sum(axis=1, keepdims=True)), 1e-12)
    table = table / size
    normal = np.swapaxes(table, 1, 2) @ table + 1e-10 * np.eye(table.shape[2])
    right = (np.swapaxes(table, 1, 2) @ data[:, :, None])[:, :, 0]
    found = np.linalg.solve(normal, right[:, :, None])[:, :, 0]
    left = data - (table @ found[:, :, None])[:, :, 0]
    return (left**2).sum(axis=1)


def columns(since: Table, leg: Swing, width: float, order: int) -> Table:
    """What unit amplitudes add to the angle (order 0) or the velocity (order 1)."""
    x = np.maximum(since - width / 2, 0) / FALL
    rest = [x**power if order == 0 else power * x ** (power - 1) / FALL for power in POWERS]
    return beside_levels([falling(since, width, leg, order), *rest], order)


def beside_levels(each: list[Table], order: int) -> Table:
    """With two more columns: the level of the angle and the gyro's bias."""
    level, none = np.ones_like(each[0]), np.zeros_like(each[0])
    return np.stack([*each, *((level, none) if order == 0 else (none, level))], axis=-1)
