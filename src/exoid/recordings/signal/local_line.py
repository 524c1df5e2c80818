"""The straight line around every sample of a channel, with missing samples bridged."""

from typing import Any

import numpy as np

from exoid.recordings.samples import Samples

AT_ONCE = 2**15  # samples, whose sums stay in the processor's cache
SMALLEST = 16  # samples of a block
FAR = 100.0  # times a usual window, of two blocks with a pause in them: more costs digits
Signal = Any  # a NumPy or a JAX array, time first


def interpolated(time: Signal, samples: Signal) -> Samples:
    known = ~np.isnan(samples)
    return np.asarray(samples) if known.all() else np.interp(time, time[known], samples[known])


def local_line(time: Samples, samples: Samples, width: float) -> tuple[Samples, Samples]:
    """Value and slope at every sample of the straight line fitted to the `width` s around it.

    Missing samples are bridged; sums run over the window, so uneven sampling does no harm, and all
    are of distances within it, so that neither a day before it nor a week's gap in it does.
    """
    filled = interpolated(time, samples)
    first = np.searchsorted(time, time - width / 2)
    last = np.searchsorted(time, time + width / 2, side="right")
    first = np.minimum(first, np.maximum(last - 3, 0))  # three samples carry a line and a check
    last = np.minimum(np.maximum(last, first + 3), time.size)
    parts = np.split(np.arange(time.size), range(AT_ONCE, time.size, AT_ONCE))
    sums = [part_sums(time, filled, first[part], last[part]) for part in parts]
    ahead, above, spread, shared = sums[0] if len(sums) == 1 else np.concatenate(sums, axis=1)
    count = last - first
    slope = (shared - ahead * above / count) / (spread - ahead**2 / count)
    return filled[first] + (above + slope * (count * (time - time[first]) - ahead)) / count, slope


def part_sums(time: Samples, value: Samples, first: np.ndarray, last: np.ndarray) -> np.ndarray:
    """`window_sums`, from those samples alone that are in the windows."""
    used = slice(int(first[0]), int(last[-1]))
    return window_sums(time[used], value[used], first - first[0], last - first[0])


def window_sums(time: Samples, value: Samples, first: np.ndarray, last: np.ndarray) -> np.ndarray:
    """Sums of t, x, t^2 and t x over the samples from `first` to before `last`, relative to the
    first.

    As differences of running sums, which begin anew in every block and reach to the end of the
    next, so that they are of distances near a window's own.
    """
    size = max(int((last - first).max()), SMALLEST)
    block = first // size
    blocks = int(block[-1]) + 1
    at = np.minimum(np.arange(blocks)[:, None] * size + np.arange(2 * size), time.size - 1)
    t, x = (each[at] - each[at[:, :1]] for each in (time, value))
    wide = t[:, -1] > FAR * float(np.median(time[last - 1] - time[first]))
    running = np.zeros((4, blocks, 2 * size + 1))
    for total, each in zip(running, (t, x, t * t, t * x), strict=True):
        np.cumsum(each, axis=1, out=total[:, 1:])
    running = running.reshape(4, -1)
    begin = block * (2 * size + 1) + first - block * size
    sums = np.take(running, begin + last - first, axis=1) - np.take(running, begin, axis=1)
    later, higher = (each[first] - each[block * size] for each in (time, value))
    found = moved(sums, last - first, later, higher)
    for each in np.flatnonzero(wide):
        inside = slice(*np.searchsorted(block, [each, each + 1]))
        found[:, inside] = summed_alone(time, value, first[inside], last[inside])
    return found


def moved(sums: np.ndarray, count: np.ndarray, later: Samples, higher: Samples) -> np.ndarray:
    """The sums relative to a later time and a higher value."""
    t, x, tt, tx = sums
    away, above = t - count * later, x - count * higher
    return np.stack([away, above, tt - later * (t + away), tx - higher * t - later * above])


def summed_alone(time: Samples, value: Samples, first: np.ndarray, last: np.ndarray) -> np.ndarray:
    """The sums of `window_sums`, window by window: for those beside a pause."""
    at = first[:, None] + np.arange(int((last - first).max()))
    inside = at < last[:, None]
    at = np.minimum(at, time.size - 1)
    t, x = (np.where(inside, each[at] - each[first][:, None], 0.0) for each in (time, value))
    return np.stack([each.sum(axis=1) for each in (t, x, t * t, t * x)])
