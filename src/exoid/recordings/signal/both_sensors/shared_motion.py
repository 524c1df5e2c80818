"""What encoder and gyro show alike: a motion, and no noise of either.

Neighbours far from a sample miss it by noise, and by a motion quicker than a leg's swing: a tremor,
a hand that catches. A motion shows in the gyro as it does in the slope of the angle; errors that a
filter has spread over many samples do not. Where the rate was made from the angle, though, both
show the errors of one sensor.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from exoid.recordings.measured.samples import FEWEST, NONE, Samples, robust_deviation, usual_step
from exoid.recordings.signal.local_line import local_line
from exoid.recordings.signal.neighbours import NEIGHBOURS, known_of
from exoid.recordings.signal.tone import piecewise

SHARE = 0.5  # of what one sensor shows beside noise, that the other shows, too, of a motion
SURE = 4.0  # standard errors of that share
USUAL = 3.0  # robust deviations: what a release or a catch adds beyond is of few samples
LEAST = 1e-4, 1e-3  # rad, rad/s: a sensor whose samples scatter by less went through a filter
OWN = 0.7  # of an angle's noise, that its slope has and a rate by another sensor has not
Pair = tuple[Samples, Samples, Samples]  # of a segment: time [s], angle [rad], rate [rad/s]


def moved_alike(pairs: Sequence[Pair], width: float, white: tuple[float, float]) -> bool:
    """Is what the rate and the angle show over `width` s a motion that both show? `white` is the
    noise of an angle [rad] and of a rate [rad/s] that neighbours do not share.
    """
    if white[0] < LEAST[0] or white[1] < LEAST[1]:
        return False
    each = [departed(*one, width) for one in pairs]
    slope, rate = (np.concatenate([one[row] for one in each]) for row in range(2))
    if rate.size < 2 * FEWEST:
        return False
    usual = np.abs(rate) < USUAL * robust_deviation(rate)
    slope, rate = slope[usual], rate[usual]
    square = float(np.sum(rate**2)) or NONE
    share = float(slope @ rate) / square
    own = float(np.sqrt(np.mean((slope - share * rate) ** 2)))
    count = width / usual_step(pairs[0][0])
    error = own * np.sqrt(max(count, 1.0) / square)
    of_noise = white[0] / (width * np.sqrt(max(count, 3.0) / 12))
    return bool(share > max(SHARE, SURE * error) and own > OWN * of_noise)


def departed(time: Samples, angle: Samples, rate: Samples, width: float) -> np.ndarray:
    """By how much the slope of the angle and the rate [rad/s], both over `width` s, depart from
    what neighbours so far apart say: two rows, of the samples that tell both.
    """
    known = ~(np.isnan(angle) | np.isnan(rate))
    time, angle, rate = time[known], angle[known], rate[known]
    if time.size <= 2 * NEIGHBOURS:
        return np.empty((2, 0))
    stride = max(round(width / usual_step(time)), 1)
    slope, mean = local_line(time, angle, width)[1], local_line(time, rate, width)[0]
    return np.stack([known_of(time, one).errors(stride)[1] for one in (slope, mean)])


def swung_alike(pairs: Sequence[Pair], frequency: float) -> bool:
    """Is a tone of the rate [Hz] that of the angle, a quarter of a period ahead and 2 pi f times as
    large?
    """
    turns, own, other = 2 * np.pi * frequency, [], []
    for time, angle, rate in pairs:
        known = ~(np.isnan(angle) | np.isnan(rate))
        if known.sum() >= FEWEST:
            cosine, sine = piecewise(time[known], angle[known], frequency).T
            other.append(turns * np.stack([sine, -cosine], axis=1))
            own.append(piecewise(time[known], rate[known], frequency))
    if not own:
        return False
    return shared(np.concatenate(own), np.concatenate(other))


def shared(rate: NDArray[np.float64], slope: NDArray[np.float64]) -> bool:
    """Is what the rate shows, cosines and sines of several pieces, what the slope of the angle
    does?
    """
    square = float(np.sum(rate**2))
    share = float(np.sum(rate * slope)) / square
    error = float(np.sqrt(np.mean((slope - share * rate) ** 2) / square))
    return share > max(SHARE, SURE * error)
