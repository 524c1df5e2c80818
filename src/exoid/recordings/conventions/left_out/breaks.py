"""Where a motion breaks off from one sample to the next: the leg is elsewhere, its speed another.

What strikes a leg changes its speed as fast, but not its place: in a step it turns by no less than
the slower and no more than the faster of the speeds at its ends. And a stop is never passed.
"""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

from exoid.recordings.measured.samples import Samples, robust_deviation

WIDE, FEWEST = 0.12, 6  # s and samples on either side, over which a swing is a parabola
SURE = 3.0  # standard deviations by which a leg is elsewhere, of the few steps whose speed jumps
LEAST = np.radians(0.25)  # rad, the same at least; an encoder's own errors are less in a step
ALONE = 3.0  # times the greatest change of speed beside it: a swing bends evenly, a strike rings
PAST = np.radians(3.0)  # rad, by which a leg goes farther at another time: there is no stop
BESIDE = 10  # steps on either side, of a gyro
EVEN = 1.5  # times the usual step: where a clock tells of a gap, no time is lost
CURVE = 2  # degree of what is fitted on either side of a step


@dataclass(frozen=True)
class Steps:
    """From sample to sample, of those that have enough others on either side."""

    speed: Samples  # rad/s, before
    turned: Samples  # rad/s, by which the speed changes
    beside: Samples  # rad/s, the greatest of that near it, of steps that it has no part in
    elsewhere: Samples  # rad, beyond what the two speeds allow; negative within
    error: Samples  # rad, standard, of that


@dataclass(frozen=True)
class Side:
    """What samples on one side of a step tell of its middle."""

    value: Samples  # rad
    slope: Samples  # rad a sample
    error: Samples  # rad, standard, of the value, by what they leave
    departs: Samples  # rad, of the nearest sample from the others, as noisy as any


def breaks(time: Samples, angle: Samples, rate: Samples | None) -> NDArray[np.int_]:
    """The samples behind them, of an angle [rad], nowhere missing, and its gyro [rad/s]."""
    step = np.diff(time)
    count = max(FEWEST, round(WIDE / float(np.median(step)))) if step.size else FEWEST
    if time.size < 4 * count:
        return np.zeros(0, dtype=int)
    seen = by_slopes(step, angle, count) if rate is None else by_gyro(step, angle, rate, count)
    clear = seen.elsewhere > np.maximum(SURE * seen.error, LEAST)
    clear &= np.abs(seen.turned) > ALONE * seen.beside
    clear &= free_ahead(angle, seen.speed, count)
    clear &= inner(step, count) < EVEN * np.median(step)
    sure = np.where(clear, seen.elsewhere / seen.error, 0.0)
    return np.flatnonzero(clear & (sure >= greatest_beside(sure, 1, count))) + count


def free_ahead(angle: Samples, speed: Samples, count: int) -> NDArray[np.bool_]:
    """Does the leg go farther at another time than where a step ends, the way it went before?"""
    high, low = (inner(each(angle[1:], angle[:-1]), count) for each in (np.maximum, np.minimum))
    return np.where(speed > 0, angle.max() - high, low - angle.min()) > PAST


def by_gyro(step: Samples, angle: Samples, rate: Samples, count: int) -> Steps:
    """What an angle goes beyond its gyro, in one step and lastingly: either sensor may be late."""
    turned = np.diff(rate)
    beyond = np.diff(angle) - step * (rate[1:] + rate[:-1]) / 2
    apart = np.concatenate([[0.0], np.cumsum(beyond)])
    middle = np.median(sliding_window_view(apart, count), axis=1)
    lasting = middle[count:] - middle[:-count]
    lasting -= np.median(near(lasting, 2 * count, mode="edge"), axis=1)
    least = np.minimum(np.abs(lasting), np.abs(inner(beyond, count)))
    return Steps(
        speed=inner(rate[:-1], count),
        turned=inner(turned, count),
        beside=inner(greatest_beside(np.abs(turned), 1, BESIDE), count),
        elsewhere=least - inner(step * np.abs(turned) / 2, count),
        error=np.full(lasting.size, robust_deviation(lasting)),
    )


def by_slopes(step: Samples, angle: Samples, count: int) -> Steps:
    """The same of an angle alone, by parabolas over the samples before and behind a step: what is
    between them in its middle, beyond what their slopes there allow. A wild sample is no end.
    """
    windows = sliding_window_view(angle, count)
    before, behind = side(windows[:-count], count - 1, 0.5), side(windows[count:], 0, -0.5)
    turned, gap = behind.slope - before.slope, behind.value - before.value
    alone = inner(np.diff(angle), count) - (behind.slope + before.slope) / 2
    usual = max(robust_deviation(gap), robust_deviation(alone))
    wild = np.maximum(np.abs(before.departs), np.abs(behind.departs)) > SURE * usual
    least = np.where(wild, 0.0, np.minimum(np.abs(gap), np.abs(alone)))
    usual_step = np.median(step)
    return Steps(
        speed=before.slope / usual_step,
        turned=turned / usual_step,
        beside=greatest_beside(np.abs(turned), count, 2 * count) / usual_step,
        elsewhere=least - np.abs(turned) / 2,
        error=np.maximum(np.hypot(before.error, behind.error), usual),
    )


def side(windows: NDArray[np.float64], end: int, beyond: float) -> Side:
    """By the parabola over each of the windows, so many samples `beyond` their `end`."""
    powers = np.vander(np.arange(windows.shape[1]), CURVE + 1, increasing=True)
    at = np.vander([end + beyond], CURVE + 1, increasing=True)[0]
    fit = np.linalg.pinv(powers)
    found = windows @ fit.T
    left = windows - found @ powers.T
    misfit = np.sqrt((left**2).sum(axis=1) / (windows.shape[1] - CURVE - 1))
    return Side(
        value=found @ at,
        slope=found[:, 1:] @ (np.arange(1, CURVE + 1) * at[:-1]),
        error=misfit * np.linalg.norm(at @ fit),
        departs=left[:, end] / np.sqrt(1 - powers[end] @ fit[:, end]),
    )


def inner(each: Samples, count: int) -> Samples:
    """Those of the steps that have so many samples on either side."""
    return each[count - 1 : each.size - count + 1]


def near(each: Samples, reach: int, mode: Literal["edge", "constant"]) -> Samples:
    """The values on either side of each, itself in the middle."""
    return sliding_window_view(np.pad(each, reach, mode=mode), 2 * reach + 1)


def greatest_beside(each: Samples, apart: int, reach: int) -> Samples:
    """The greatest of the values from so far `apart` up to `reach` on either side."""
    far = np.abs(np.arange(-reach, reach + 1)) >= apart
    return near(each, reach, "constant")[:, far].max(axis=1)
