"""The straight line around every sample of a channel, with missing samples bridged."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from exoid.recordings.measured.samples import Samples

AT_ONCE = 2**12  # samples, whose sums stay in the processor's cache
WINDOWS = 8  # the least at once, for what is read beyond a part to be little
SMALLEST = 16  # samples of a block
FAR = 100.0  # times the shortest window, of two blocks with a pause in them: more costs digits
Signal = Any  # a NumPy or a JAX array, time first
Sums = NDArray[np.complex128]


def interpolated(time: Signal, samples: Signal) -> Samples:
    known = ~np.isnan(samples)
    return np.asarray(samples) if known.all() else np.interp(time, time[known], samples[known])


def local_line(time: Samples, samples: Samples, width: float) -> tuple[Samples, Samples]:
    """Value and slope at every sample of the straight line fitted to the `width` s around it.

    Missing samples are bridged; sums run over the window, so uneven sampling does no harm, and all
    are of distances within it, so that neither a day before it nor a week's gap in it does.
    """
    filled = interpolated(time, samples)
    usual = int(time.size * width / (time[-1] - time[0])) if time.size > 1 else 1
    size = max(AT_ONCE, WINDOWS * usual)
    parts = [slice(begin, begin + size) for begin in range(0, time.size, size)]
    each = [lines_at(time, filled, width, part) for part in parts]
    value, slope = each[0] if len(each) == 1 else map(np.concatenate, zip(*each, strict=True))
    return value, slope


def lines_at(time: Samples, value: Samples, width: float, part: slice) -> tuple[Samples, Samples]:
    """Those of `local_line` at some samples, from those alone that are in their windows."""
    at = time[part]
    begin, end = at - width / 2, at + width / 2
    near = slice(
        int(np.searchsorted(time, begin[0])), int(np.searchsorted(time, end[-1], side="right"))
    )
    first = near.start + np.searchsorted(time[near], begin)
    last = near.start + np.searchsorted(time[near], end, side="right")
    first = np.minimum(first, np.maximum(last - 3, 0))  # three samples carry a line and a check
    last = np.minimum(np.maximum(last, first + 3), time.size)
    used = slice(int(first[0]), int(last[-1]))
    first, last = first - used.start, last - used.start
    count = last - first
    first_order, second_order = window_sums(time[used], value[used], first, last)
    ahead, above = first_order.real, first_order.imag
    slope = (second_order.imag - ahead * above / count) / (second_order.real - ahead**2 / count)
    since = count * (at - time[used][first]) - ahead
    return value[used][first] + (above + slope * since) / count, slope


def window_sums(time: Samples, value: Samples, first: np.ndarray, last: np.ndarray) -> Sums:
    """Sums of z = t + i x and of t z over the samples from `first` to before `last`, relative to
    the first.

    As differences of running sums, which begin anew in every block and reach to the end of the
    next, so that they are of distances near a window's own. One complex sum takes half the time of
    two.
    """
    size = max(int((last - first).max()), SMALLEST)
    block = first // size
    terms = in_blocks(time, value, size, int(block[-1]) + 1)
    running = np.zeros((*terms.shape[:2], 2 * size + 1), dtype=complex)
    np.cumsum(terms, axis=2, out=running[..., 1:])
    place = first + block * size  # among the samples of all blocks
    begin = place + block
    count = last - first
    running = running.reshape(2, -1)
    sums: Sums = np.take(running, begin + count, axis=1) - np.take(running, begin, axis=1)
    z, tz = sums
    shift: Sums = np.take(terms[0], place)
    own = z - count * shift
    found = np.stack([own, tz - shift.real * z - shift * own.real])
    lasting = terms[0, :, -1].real
    for each in np.flatnonzero(lasting > FAR * float((time[last - 1] - time[first]).min())):
        inside = slice(*np.searchsorted(block, [each, each + 1]))
        found[:, inside] = summed_alone(time, value, first[inside], last[inside])
    return found


def in_blocks(time: Samples, value: Samples, size: int, blocks: int) -> Sums:
    """z and t z (first axis) in every block (second) of `size` samples and the block after it
    (third), relative to its first sample.
    """
    padded: Sums = np.empty((blocks + 1) * size, dtype=complex)
    padded.real[: time.size], padded.imag[: time.size] = time, value
    padded[time.size :] = padded[time.size - 1]
    alone = padded.reshape(blocks + 1, size)
    both = np.concatenate([alone[:-1], alone[1:]], axis=1)
    terms: Sums = np.empty((2, blocks, 2 * size), dtype=complex)
    np.subtract(both, both[:, :1], out=terms[0])
    np.multiply(terms[0].real, terms[0], out=terms[1])
    return terms


def summed_alone(time: Samples, value: Samples, first: np.ndarray, last: np.ndarray) -> np.ndarray:
    """The sums of `window_sums`, window by window: for those beside a pause."""
    at = first[:, None] + np.arange(int((last - first).max()))
    inside = at < last[:, None]
    at = np.minimum(at, time.size - 1)
    t, x = (np.where(inside, each[at] - each[first][:, None], 0.0) for each in (time, value))
    z = t + 1j * x
    return np.stack([z.sum(axis=1), (t * z).sum(axis=1)])
