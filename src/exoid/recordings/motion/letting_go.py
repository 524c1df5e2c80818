"""When a hand let go of a leg, by the likelihood of every instant and duration.

Held at phi_s until t0; over w seconds the hand's torque fades evenly; then the leg is free:

    phi = phi_s + a y(t - t0, w) + b x^3 + c x^4 + e x^5,   x = t - t0 - w / 2 > 0

with y of `fall` for one of a few legs, and small b, c, e for what this leg does otherwise.
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from exoid.recordings.motion.fall import Swing, Swings, falling
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
    legs: Swings = tuple(Swing(*each) for each in LEGS)


def let_go(case: ReleaseWindow, low: float, high: float) -> LettingGo:
    """The release between `low` and `high` s: first roughly and of many legs, then finely."""
    rough = np.arange(low, high + COARSE, COARSE)
    widths = WINDOWS[:: WINDOWS.size // 2]
    every = table_of(case, case.legs, rough, widths)
    leg = case.legs[int(np.argmin(every.min(axis=(1, 2))))]
    scale = spread(case, every)
    weight = np.exp(-(every.min(axis=0) - every.min()) / 2 / scale).sum(axis=0)
    kept = rough[weight > weight.max() * 1e-4]
    step = np.clip((kept[-1] - kept[0]) / 60, *TRIED)
    tried = np.arange(max(low, kept[0] - COARSE), min(high, kept[-1] + COARSE) + step, step)
    square = table_of(case, (leg,), tried, WINDOWS)[0]
    found = summed(tried, square, spread(case, square), case)
    return replace(found, error=max(found.error, wobble(rough, widths, every, scale)))


def wobble(tried: Samples, widths: Samples, square: Table, scale: float) -> float:
    """The scatter of the release over all legs [s], where that is more than of the best leg."""
    weight = np.exp(-(square - square.min()) / 2 / scale)
    effective = np.broadcast_to(tried[None, :] + widths[:, None] / 2, square.shape)
    mean = np.average(effective, weights=weight)
    return float(np.sqrt(np.average((effective - mean) ** 2, weights=weight)))


def table_of(case: ReleaseWindow, legs: Swings, tried: Samples, widths: Samples) -> Table:
    """Chi-square of every leg, duration and instant."""
    return np.stack([misfits(case, legs, tried, width) for width in widths.tolist()], axis=1)


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


def misfits(case: ReleaseWindow, legs: Swings, tried: Samples, width: float) -> Table:
    """Chi-square of every leg and tried instant, all amplitudes at their best."""
    since = case.signal.time - tried[:, None]
    x = np.maximum(since - width / 2, 0) / FALL
    fall = measured(case, [falling(since, width, legs, order) for order in (0, 1)])
    other = [measured(case, [power_of(x, n, order) for order in (0, 1)]) for n in POWERS]
    room = np.array(case.room) * np.clip(case.pull / GREATEST, 0.02, 1.0)
    believed = np.broadcast_to(np.diag(1 / room), (tried.size, len(POWERS), len(POWERS)))
    shared = np.concatenate([np.stack(other, axis=-1), believed], axis=1)
    return left_of(case, np.pad(fall, [(0, 0), (0, 0), (0, len(POWERS))]), shared)


def begun_free(case: ReleaseWindow) -> float:
    """Chi-square of a leg that is free from the first sample on, at rest or in motion."""
    since = case.signal.time[None, :] - case.signal.time[0]
    at_rest, moving = (
        measured(case, [falling(since, 0.0, case.legs, order + begun) for order in (0, 1)])
        for begun in (0, 1)
    )
    legs = zip(at_rest[:, None], moving[..., None], strict=True)
    return min(float(left_of(case, rest, begun)[0, 0]) for rest, begun in legs)


def power_of(x: Table, power: int, order: int) -> Table:
    """x^power, or its derivative by time; by products, which take a tenth of a power's time."""
    found = x
    for _ in range(power - 1 - order):
        found = found * x
    return power / FALL * found if order else found


def measured(case: ReleaseWindow, tables: list[Table]) -> Table:
    """What is told of angle and velocity (last axis: time) at the samples of encoder and gyro, over
    their noise.
    """
    signal, found = case.signal, []
    channels = ((signal.angle, signal.angle_noise), (signal.velocity, signal.velocity_noise))
    for table, (samples, noise) in zip(tables, channels, strict=True):
        if samples is not None:
            found.append(table[..., ~np.isnan(samples)] / noise)
    return np.concatenate(found, axis=-1)


def left_of(case: ReleaseWindow, fall: Table, shared: Table) -> Table:
    """The sum of squares that is left of the data for every leg and instant.

    `fall` is (leg, instant, row), what all legs share (instant, row, column); the level of the
    angle and the gyro's bias are free, too. Columns that are shared are taken out once for all.
    """
    signal = case.signal
    channels = [signal.angle] if signal.velocity is None else [signal.angle, signal.velocity]
    ones, none = np.ones(signal.time.size), np.zeros(signal.time.size)
    levels = [measured(case, [ones, none]), measured(case, [none, ones])][: len(channels)]
    known = np.stack([measured(case, [*channels, none][:2]), *levels], axis=-1)
    known = np.pad(known, [(0, fall.shape[-1] - known.shape[0]), (0, 0)])
    known = np.broadcast_to(known, (*shared.shape[:1], *known.shape))
    basis = np.linalg.qr(np.concatenate([shared, known[..., 1:]], axis=-1))[0]

    def beyond(each: Table) -> Table:  # (..., instant, row)
        along = each[..., None, :] @ basis
        return each - (along @ np.swapaxes(basis, 1, 2))[..., 0, :]

    data, falls = beyond(known[..., 0]), beyond(fall)
    size = (falls**2).sum(axis=-1)
    tells = size > 1e-10 * (fall**2).sum(axis=-1)  # an instant after the last sample tells nothing
    gained = np.where(tells, (falls * data).sum(axis=-1) ** 2 / np.where(tells, size, 1.0), 0.0)
    return (data**2).sum(axis=-1) - gained
