"""The straight line around every sample of a channel, with missing samples bridged."""

from typing import Any

import numpy as np

from exoid.recordings.samples import Samples

Signal = Any  # a NumPy or a JAX array, time first


def interpolated(time: Signal, samples: Signal) -> Samples:
    known = ~np.isnan(samples)
    return np.interp(time, time[known], samples[known])


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
    count, ahead, above, spread, shared = window_sums(time, filled, first, last - first)
    slope = (shared - ahead * above / count) / (spread - ahead**2 / count)
    return filled[first] + (above + slope * (count * (time - time[first]) - ahead)) / count, slope


def window_sums(time: Samples, value: Samples, first: np.ndarray, count: np.ndarray) -> np.ndarray:
    """Sums of 1, t, x, t^2 and t x over `count` samples from `first` on, both relative to it.

    Doubling: sums of 1, 2, 4, ... samples from every sample on, of which a window takes those that
    its count in binary asks for.
    """
    total, at = np.zeros((5, first.size)), first
    sums = np.zeros((5, time.size))
    sums[0] = 1.0
    length, here, end = 1, np.arange(time.size), time.size - 1

    def moved(begin: np.ndarray, origin: np.ndarray) -> np.ndarray:
        later, higher = time[begin] - time[origin], value[begin] - value[origin]
        one, t, x, tt, tx = sums[:, begin]
        t_moved, x_moved = t + one * later, x + one * higher
        return np.stack(
            [one, t_moved, x_moved, tt + later * (t + t_moved), tx + higher * t + later * x_moved]
        )

    while length <= count.max():
        taken = (count & length) > 0
        total = total + taken * moved(np.minimum(at, end), first)
        at = at + taken * length
        sums = sums + moved(np.minimum(here + length, end), here)
        length *= 2
    return total
