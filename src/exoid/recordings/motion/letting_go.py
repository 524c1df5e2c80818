"""When a hand let go of a leg, by the likelihood of every instant and duration.

Held at phi_s until t0; over w seconds the hand's torque fades evenly; then the leg is free:

    phi = phi_s + a y(t - t0, w) + b x^3 + c x^4 + e x^5,   x = t - t0 - w / 2 > 0

with y of `fall` for one of a few legs, and small b, c, e for what this leg does otherwise. Where
the hand swayed, beside a speed and an acceleration from before that go on: what begins at t0 is the
difference.
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from exoid.recordings.measured.samples import Samples
from exoid.recordings.motion.fall import BELIEVED, Rows, Swing, Swings, rows_of
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

POWERS = (3, 4, 5)
SWAY = (1, 2)

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
    swayed: bool = False  # by the hand, which moves the leg until it lets go
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
    """Chi-square of every leg, duration and instant, all amplitudes at their best."""
    rows = rows_of(case.signal, float(case.signal.time[0] if case.swayed else tried.min()))
    since = rows.time - tried[:, None]
    fall = rows.fallen(since, widths, legs)
    middle = (since - widths[:, None, None] / 2).reshape(-1, rows.time.size)
    columns = powers_of(case, rows, np.maximum(middle, 0) / FALL)
    if case.swayed:
        columns = np.concatenate([columns, in_hand(rows, columns.shape[0])], axis=1)
    left = rows.left(columns, fall)
    return left.reshape(widths.size, tried.size, len(legs)).transpose(2, 0, 1)


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


def powers_of(case: ReleaseWindow, rows: Rows, x: Table) -> Table:
    """x^3, x^4 and x^5 in every row (instant, power, row), with what is believed of each."""
    room = np.array(case.room) * np.clip(case.pull / GREATEST, 0.02, 1.0)
    angle, velocity = x[:, : rows.velocity], x[:, rows.velocity :]
    each = [
        np.concatenate([power_of(angle, n, 0), power_of(velocity, n, 1)], axis=1) for n in POWERS
    ]
    found = np.stack(each, axis=1) * rows.scale
    at = np.arange(len(POWERS))
    found[:, at, at] = 1 / room
    return found


def in_hand(rows: Rows, count: int) -> Table:
    """A speed and an acceleration that a hand gave the leg, in every row (`count`, power, row)."""
    x = (rows.time - rows.time[BELIEVED]) / FALL
    x[:BELIEVED] = 0.0
    angle, velocity = x[: rows.velocity], x[rows.velocity :]
    each = [np.concatenate([power_of(angle, n, 0), power_of(velocity, n, 1)]) for n in SWAY]
    found = np.stack(each) * rows.scale
    found[:, :BELIEVED] = 0.0
    return np.broadcast_to(found, (count, *found.shape))


def power_of(x: Table, power: int, order: int) -> Table:
    """x^power, or its derivative by time; by products, which take a tenth of a power's time."""
    found = x if power > order else np.ones_like(x)
    for _ in range(power - 1 - order):
        found = found * x
    return power / FALL * found if order else found


def begun_free(case: ReleaseWindow) -> float:
    """Chi-square of a leg that is free from the first sample on, at rest or in motion."""
    first = float(case.signal.time[0])
    rows = rows_of(case.signal, first)
    since = rows.time[None, :] - first
    at_rest, moving = (rows.fallen(since, np.zeros(1), case.legs, begun) for begun in (0, 1))
    left = rows.left(moving.transpose(2, 0, 1).copy(), at_rest.transpose(2, 1, 0))
    return float(left.min())
