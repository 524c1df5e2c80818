"""When a hand let go of a leg, by the likelihood of every instant and duration.

Held at phi_s until t0; over w seconds the hand's torque fades evenly; then the leg is free:

    phi = phi_s + a r(t - t0, w) + b x^3 + c x^4 + e x^5,   x = t - t0 - w / 2 > 0,
    r'' = min((t - t0) / w, 1).
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from exoid.recording.motion.limits import BENDS, GONE, TAIL, TRIED, WINDOWS
from exoid.recording.motion.signal import Signal
from exoid.recording.recording import Samples

POWERS = (3, 4, 5)
SCALE = 0.25  # s, the unit of x: columns of like size

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


def let_go(signal: Signal, low: float, high: float, window: tuple[float, float]) -> LettingGo:
    """The release between `low` and `high` s, judged by the samples within `window`."""
    tried = np.arange(low, high + TRIED[1] / 2, np.clip(signal.step / 4, *TRIED))
    square = np.stack([misfits(signal, tried, width, window) for width in WINDOWS])
    count = samples_within(signal, window)
    best = float(square.min())
    scale = max(1.0, best / max(count - 6, 1))
    weight = np.exp(-(square - best) / 2 / scale)
    weight /= weight.sum()
    effective = tried[None, :] + WINDOWS[:, None] / 2
    release = float(np.sum(weight * effective))
    error = float(np.sqrt(np.sum(weight * (effective - release) ** 2) + signal.step**2 / 192))
    begin = quantile(np.broadcast_to(tried, weight.shape), weight, 1 - GONE)
    gone = quantile(tried[None, :] + (1 + TAIL) * WINDOWS[:, None], weight, GONE)
    return LettingGo(begin, release, error, gone, best / max(count, 1), best)


def quantile(values: Table, weight: Table, share: float) -> float:
    order = np.argsort(values, axis=None)
    total = np.cumsum(weight.ravel()[order])
    return float(values.ravel()[order][min(np.searchsorted(total, share), total.size - 1)])


def samples_within(signal: Signal, window: tuple[float, float]) -> int:
    inside = (signal.time >= window[0]) & (signal.time <= window[1])
    count = int(np.sum(inside & ~np.isnan(signal.angle)))
    if signal.velocity is not None:
        count += int(np.sum(inside & ~np.isnan(signal.velocity)))
    return count


def misfits(signal: Signal, tried: Samples, width: float, window: tuple[float, float]) -> Samples:
    """Chi-square of every tried instant, its amplitudes at their best."""
    inside = (signal.time >= window[0]) & (signal.time <= window[1])
    seen = inside & ~np.isnan(signal.angle)
    table = columns(signal.time[seen][None, :] - tried[:, None], width, 0) / signal.angle_noise
    data = np.broadcast_to(signal.angle[seen] / signal.angle_noise, table.shape[:2])
    if signal.velocity is not None:
        seen = inside & ~np.isnan(signal.velocity)
        slopes = columns(signal.time[seen][None, :] - tried[:, None], width, 1)
        table = np.concatenate([table, slopes / signal.velocity_noise], axis=1)
        speeds = signal.velocity[seen] / signal.velocity_noise
        data = np.concatenate([data, np.broadcast_to(speeds, slopes.shape[:2])], axis=1)
    believed = np.zeros((tried.size, len(POWERS), table.shape[2]))
    believed[:, range(len(POWERS)), range(1, 1 + len(POWERS))] = 1 / np.array(BENDS)
    table = np.concatenate([table, believed], axis=1)
    data = np.concatenate([data, np.zeros(believed.shape[:2])], axis=1)
    return least_squares(table, data)


def begun_free(signal: Signal, window: tuple[float, float]) -> float:
    """Chi-square of a leg that is free from the first sample on: a polynomial of order 4."""
    begin = signal.time[0]
    inside = (signal.time >= window[0]) & (signal.time <= window[1])
    seen = inside & ~np.isnan(signal.angle)
    table = powers(signal.time[seen] - begin, 0) / signal.angle_noise
    data = signal.angle[seen] / signal.angle_noise
    if signal.velocity is not None:
        seen = inside & ~np.isnan(signal.velocity)
        slopes = powers(signal.time[seen] - begin, 1) / signal.velocity_noise
        table = np.concatenate([table, slopes])
        data = np.concatenate([data, signal.velocity[seen] / signal.velocity_noise])
    return float(least_squares(table[None], data[None])[0])


def powers(since: Samples, order: int) -> Table:
    """1, x, x^2, x^3, x^4 or their derivatives."""
    x = (since / SCALE)[:, None]
    each = np.arange(5)
    return x**each if order == 0 else each * x ** np.maximum(each - 1, 0) / SCALE


def least_squares(table: Table, data: Table) -> Samples:
    """The sum of squares that is left of every row of `data` (try, sample)."""
    size = np.maximum(np.sqrt((table**2).sum(axis=1, keepdims=True)), 1e-12)
    table = table / size
    normal = np.swapaxes(table, 1, 2) @ table + 1e-10 * np.eye(table.shape[2])
    right = (np.swapaxes(table, 1, 2) @ data[:, :, None])[:, :, 0]
    found = np.linalg.solve(normal, right[:, :, None])[:, :, 0]
    left = data - (table @ found[:, :, None])[:, :, 0]
    return (left**2).sum(axis=1)


def columns(since: Table, width: float, order: int) -> Table:
    """What unit amplitudes add to the angle (order 0) or the velocity (order 1).

    The last two columns are the level and the gyro's bias.
    """
    x = np.maximum(since - width / 2, 0) / SCALE
    each = [ramp(since, width, order)]
    for power in POWERS:
        each.append(x**power if order == 0 else power * x ** (power - 1) / SCALE)
    level = np.ones_like(since)
    each += [level, 0 * level] if order == 0 else [0 * level, level]
    return np.stack(each, axis=-1)


def ramp(since: Table, width: float, order: int) -> Table:
    """r(t - t0, w) of the module's docstring, or its derivative."""
    x = np.maximum(since, 0)
    fading, y = x < width, x - width / 2
    if order == 0:
        return np.where(fading, x**3 / (6 * width or 1.0), y**2 / 2 + width**2 / 24)
    return np.where(fading, x**2 / (2 * width or 1.0), y)
