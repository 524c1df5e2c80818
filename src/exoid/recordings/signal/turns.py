"""Where a signal turns, and how fast it therefore moves."""

import numpy as np

from exoid.recordings.measured.samples import Samples, usual_step

TURN = 0.1  # of its travel: how far it moves back before a turn counts
QUICK = 25.0  # rad/s: what turns less often is a leg, or as slow as one
COARSE = 0.2  # rad of an oscillation between two samples, from which on neighbours see it as noise


def pace(time: Samples, samples: Samples) -> float:
    """How many radians of an oscillation a signal passes in a second: pi from turn to turn.

    By the median time between turns, so that neither a rest nor a few quick ones count.
    """
    known = ~np.isnan(samples)
    at = turns(samples[known])
    if at.size < 3:
        return 0.0
    return float(np.pi / np.median(np.diff(time[known][at])))


def turns(samples: Samples, part: float = TURN) -> np.ndarray:
    """The samples of the extremes between which it moves by more than this part of its travel."""
    least, found = part * float(np.ptp(samples)), []
    extreme, way = 0, 0.0  # way: +1 while it rises, 0 before it is known
    places = bends(samples)
    for at, value in zip(places.tolist(), samples[places].tolist(), strict=True):
        ahead = value - samples[extreme]
        if way * ahead >= 0 and way != 0:
            extreme = at
        elif abs(ahead) > least:
            found.append(extreme)
            extreme, way = at, float(np.sign(ahead))
    return np.array(found, dtype=int)


def bends(samples: Samples) -> np.ndarray:
    """The first sample, the last, and all that do not lie between their neighbours: whatever turns
    around does so at one of them.
    """
    steps = np.sign(np.diff(samples))
    on = np.zeros(samples.size, dtype=bool)
    on[1:-1] = steps[1:] * steps[:-1] > 0
    return np.flatnonzero(~on)


def coarse(time: Samples, samples: Samples) -> bool:
    """Does it oscillate quicker than any leg, with few samples to a period?"""
    rate = pace(time, samples)
    return rate > QUICK and rate * usual_step(time) > COARSE
