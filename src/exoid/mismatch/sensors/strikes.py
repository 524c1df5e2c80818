"""The steps between samples in which something strikes the leg: no samples tell what it did there.

A rate that changes far more within a step than in the steps beside it was struck: by a stop, by
play, or by a foot that meets the ground. What is softer shows as a jerk beyond the usual.
"""

import numpy as np

from exoid.mismatch.sensors.smooth import Pairs, Samples, Steps, smooth

STRUCK = 6.0  # standard deviations of a change that only a strike makes
CHANGE = 5**0.5  # standard deviation of a step's change beside its neighbours', over a rate's
NORMAL = 1.4826  # standard deviation over the median of what is normal
UNUSUAL = 3.0  # standard deviations of a jerk
ROUNDS = 4  # for the first strikes make others seem usual
SELDOM = 0.1  # of all steps, up to which strikes are what is unusual
LEAST = 8  # samples that show what is usual


def strikes(time: Samples, data: Pairs, weights: Pairs) -> Steps:
    """Those in which the gyro shows a strike, and the steps beside them."""
    struck = sharp(time, data[:, 1], weights[:, 1])
    for _ in range(ROUNDS):
        more = beside(np.abs(smooth(time, data, weights, struck).jerks) > UNUSUAL)
        if (more <= struck).all() or (more | struck).mean() > SELDOM:
            break
        struck |= more
    return struck


def sharp(time: Samples, rate: Samples, weight: Samples) -> Steps:
    """Strikes that a gyro shows by itself, within a sample."""
    struck = np.zeros(time.size - 1, bool)
    seen = np.flatnonzero(weight > 0)
    if seen.size < LEAST:
        return struck
    steps = np.diff(time[seen])
    slopes = np.diff(rate[seen]) / steps
    changes = np.abs(slopes[1:-1] - (slopes[:-2] + slopes[2:]) / 2)
    noise = CHANGE / (weight.max() * np.median(steps))
    usual = max(noise, NORMAL * float(np.median(changes)))
    for at in 1 + np.flatnonzero(changes > STRUCK * usual):
        struck[seen[at] : seen[at + 1]] = True
    return beside(struck)


def beside(steps: Steps) -> Steps:
    """With those before and after."""
    return np.convolve(steps, [True] * 3, mode="same").astype(bool)
