"""What rounding does to a mean where a leg stands still: samples of one code err alike.

Noise or motion by a step and more takes a sensor through its codes, and the errors of rounding
average away as white noise does. Samples in a row that show the same code have one error together,
anywhere within half a step: no number of them makes a mean better.
"""

import numpy as np
from numpy.typing import NDArray

from exoid.recordings.measured.samples import ROUNDING, Samples


def least_step(shown: Samples) -> float:
    """The least by which two angles differ that a sensor shows; 0 where it shows one alone."""
    steps = np.diff(np.unique(shown))
    return float(min(steps[steps > ROUNDING], default=0.0))


def stretches(shown: Samples) -> NDArray[np.int_]:
    """Where each stretch of samples in a row begins that are alike."""
    return np.concatenate([[0], np.flatnonzero(np.abs(np.diff(shown)) > ROUNDING) + 1])


def shared(weights: NDArray[np.floating], shown: Samples) -> Samples:
    """What a step of rounding does to sums of samples with these weights (sum, sample): two columns
    for every stretch of more than one sample that shows the same, whose error is anywhere within
    half a step, and may go from one end of it to the other.
    """
    begins = stretches(shown)
    counts = np.diff(begins, append=shown.size)
    last = np.repeat(np.maximum(counts - 1, 1), counts)
    way = 2 * (np.arange(shown.size) - np.repeat(begins, counts)) / last - 1
    sums = (np.add.reduceat(each, begins, axis=-1) for each in (weights, weights * way))
    return np.concatenate([each[:, counts > 1] for each in sums], axis=-1) / np.sqrt(12)
