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
HAND = 0.2  # s from the first sample on, in which what let go of the leg may show
NEARBY = 8  # steps to either side, of which most show what is usual there
AS_MUCH = 0.5  # of a jump, within which the next one takes it back
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
    before, behind, usual = by_neighbours(time[seen], rate[seen], weight[seen])
    for at in 1 + np.flatnonzero(np.abs(before + behind) > 2 * STRUCK * usual):
        struck[seen[at] : seen[at + 1]] = True
    return beside(struck)


def times_of_strikes(time: Samples, rate: Samples, weight: Samples) -> np.ndarray:
    """When [s] the rate jumps within a step: it changes far more than in the step before, and than
    in the one behind. A torque that only begins or ends there, as friction at a turn, makes it
    change as in one of the two. Where a hand lets go, nothing is counted, nor what other steps
    nearby show, too, as where times are off, nor a lone sample that is off.
    """
    seen = np.flatnonzero(weight > 0)
    if seen.size < LEAST:
        return np.zeros(0)
    before, behind, usual = by_neighbours(time[seen], rate[seen], weight[seen])
    free, change = time[seen][1:-2] > time[seen][0] + HAND, (before + behind) / 2
    jumps = np.where(before * behind > 0, np.minimum(np.abs(before), np.abs(behind)), 0.0)
    struck = free & (jumps > STRUCK * np.maximum(usual, NORMAL * nearby(np.abs(change))))
    back = np.abs(change[:-1] + change[1:]) < AS_MUCH * np.abs(change[:-1])
    lone = struck[:-1] & struck[1:] & back
    struck &= ~np.append(lone, False) & ~np.append(False, lone)
    steps = 1 + np.flatnonzero(struck)
    return (time[seen[steps]] + time[seen[steps + 1]]) / 2


def nearby(change: np.ndarray) -> np.ndarray:
    """The median of what the steps around each show."""
    around = np.pad(change, NEARBY, mode="reflect" if change.size > NEARBY else "edge")
    return np.median(np.lib.stride_tricks.sliding_window_view(around, 2 * NEARBY + 1), axis=1)


def by_neighbours(
    time: Samples, rate: Samples, weight: Samples
) -> tuple[np.ndarray, np.ndarray, float]:
    """By how much the rate's slope in a step differs from that in the step before, and from that in
    the one behind, of all steps but the first and the last, and how much is usual [rad/s^2].
    """
    steps = np.diff(time)
    slopes = np.diff(rate) / steps
    before, behind = slopes[1:-1] - slopes[:-2], slopes[1:-1] - slopes[2:]
    noise = CHANGE / (weight.max() * np.median(steps))
    return before, behind, max(noise, NORMAL * float(np.median(np.abs(before + behind) / 2)))


def beside(steps: Steps) -> Steps:
    """With those before and after."""
    return np.convolve(steps, [True] * 3, mode="same").astype(bool)
