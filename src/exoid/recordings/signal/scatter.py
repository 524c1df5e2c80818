"""How far numbers scatter, wild ones apart, and the step in which they come."""

import numpy as np

from exoid.recordings.measured.samples import NORMAL, ROUNDING, Samples, quantile

FAR = 5.0  # standard deviations of a spike: of clean samples one in 1.7 million
FEWEST = 30  # samples that tell a noise to 15 %
NONE = 1e-6  # noise of a signal without any: below every sensor's
EVEN = 0.05  # of a step: differences that are as close to multiples of it on average are multiples


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
