"""Numbers of a channel, sample by sample: how far they scatter, and in which steps they come."""

import numpy as np
from numpy.typing import NDArray

Samples = NDArray[np.float64]  # one value per sample; jaxtyping here would cost 0.1 s at start
FASTEST = 35.0  # rad/s, 2000 deg/s: more no gyro of a leg or a rig tells
NORMAL = 0.6745  # median of |x| over the standard deviation of a normal distribution
ROUNDING = 1e-7  # rad or rad/s, of numbers in a file: no step of a sensor
FAR = 5.0  # standard deviations of a spike: of clean samples one in 1.7 million
FEWEST = 30  # samples that tell a noise to 15 %
NONE = 1e-6  # noise of a signal without any: below every sensor's
EVEN = 0.05  # of a step: differences that are as close to multiples of it on average are multiples


def quantile(values: Samples, share: float = 0.5) -> float:
    """What so large a share of known numbers lies below; of a half, their median.

    numpy's own takes several times as long for a thousand numbers, of which a drop has many.
    """
    place = share * (values.size - 1)
    low = int(place)
    high = min(low + 1, values.size - 1)
    ordered = np.partition(values, (low, high))
    return float(ordered[low] + (ordered[high] - ordered[low]) * (place - low))


def robust_deviation(errors: Samples, least: float = 0.0) -> float:
    """The standard deviation of a normal distribution with this median size."""
    errors = errors[~np.isnan(errors)]
    median = quantile(np.abs(errors)) / NORMAL
    return max(median, least) or float(np.std(errors)) or NONE


def quantum(signals: list[Samples]) -> float:
    """The step of a signal that only takes multiples of one, 0 where it has none."""
    values = np.concatenate([each[~np.isnan(each)] for each in signals])
    steps = np.diff(np.sort(values))
    steps = steps[steps > ROUNDING]
    if steps.size < FEWEST:
        return 0.0
    step = float(steps.min())
    parts = steps / step
    return step if np.abs(parts - np.round(parts)).mean() < EVEN else 0.0


def usual_step(time: Samples) -> float:
    """The median time from sample to sample."""
    return quantile(np.diff(time))


def block_size(step: float, width: float) -> int:
    """How many samples, `step` s apart, fit into `width` s; one at least."""
    return max(int(width / step * (1 + 1e-6)), 1)  # a step of 1 ms is one of 1.0000000001 ms too


def block_means(samples: Samples, count: int) -> Samples:
    """Means of the known samples in every `count`; the last that fill no block are left out."""
    if count == 1:
        return samples
    blocks = samples[: samples.size // count * count].reshape(-1, count)
    known = ~np.isnan(blocks)
    number = known.sum(axis=1)
    total = np.where(known, blocks, 0.0).sum(axis=1)
    return np.divide(total, number, out=np.full(number.size, np.nan), where=number > 0)


def goes_round(time: Samples, angle: Samples) -> bool:
    """Does an angle [rad] go round and round? Then it never comes back by a turn, or its steps are
    those of something that turns no faster than a gyro can tell. Degrees swing back, and faster.
    """
    known = ~np.isnan(angle)
    place, at = angle[known], time[known]
    if not np.isfinite(place).all():
        return False
    ahead = place * np.sign(place[-1] - place[0])
    onwards = float((np.maximum.accumulate(ahead) - ahead).max()) < 2 * np.pi
    return onwards or float(np.abs(np.diff(place) / np.diff(at)).max()) < FASTEST
