"""Single wild samples: which of a signal are none of its motion."""

import numpy as np
from numpy.typing import NDArray

from exoid.recordings.samples import Samples
from exoid.recordings.signal.neighbours import NEIGHBOURS, interpolation_errors, renew
from exoid.recordings.signal.scatter import FAR, quantum, robust_deviation

REACH = 2 * NEIGHBOURS + 1
SMALLEST = 1e-3  # rad or rad/s, of a spike: smaller ones change nothing, and a release has them
CLUSTER = 5  # samples, among which more than one spike are no spikes but an event
ROUNDS = 30  # each takes the worst sample of every neighbourhood
STILL, MOVING = 1.0, 2.0  # range of seven samples, over what a spike departs by at least


def find_spikes(time: Samples, samples: Samples, least: float = 0.0) -> NDArray[np.bool_]:
    """Which samples stand alone, farther from their neighbours than noise throws one; `least` is
    what the noise is at least.

    Where the sample is taken away its neighbours agree with each other. A jump that lasts (a stop
    that is hit, play that ends) leaves more than one in a row: that is motion, and stays. Two close
    to each other go where both are beyond all around them.
    """
    found = np.zeros(samples.size, dtype=bool)
    errors = interpolation_errors(time, samples)
    if np.isnan(errors).all():
        return found
    least = max(least, quantum([samples]) / np.sqrt(12))
    limit = max(FAR * robust_deviation(errors, least), SMALLEST)
    for _ in range(ROUNDS):
        size = np.abs(errors)
        wild = np.flatnonzero(size > limit)
        if not wild.size:
            break
        around = np.clip(
            wild[:, None] + np.arange(-NEIGHBOURS, REACH - NEIGHBOURS), 0, size.size - 1
        )
        worst = wild[size[wild] == np.fmax.reduce(size[around], axis=1)]
        found[worst] = True
        renew(errors, time, np.where(found, np.nan, samples), worst)
    if not found.any():
        return found
    found = pardoned(time, samples, found, limit)
    kept = np.where(found, np.nan, samples)
    single, pair = alone(found, 1), alone(found, 2)
    for at in np.flatnonzero(found):
        before, after = kept[max(at - REACH, 0) : at], kept[at + 1 : at + 1 + REACH]
        bend = begins_or_ends(before, after, limit)
        wild = stands_out(samples[at], before, after, limit)
        found[at] = pair[at] if wild else single[at] and not bend
    return found


def stands_out(sample: float, before: Samples, after: Samples, limit: float) -> bool:
    """Is it beyond all that is around it? Where the signal jumps or bends it lies between."""
    around = np.concatenate([before, after])
    if np.isnan(around).all():
        return False
    return not np.nanmin(around) - limit < sample < np.nanmax(around) + limit


def begins_or_ends(before: Samples, after: Samples, limit: float) -> bool:
    """Is the signal still on one side only? A gyro bends where a leg is let go."""
    if np.isnan(before).all() or np.isnan(after).all():
        return False
    still, moving = sorted(np.nanmax(each) - np.nanmin(each) for each in (before, after))
    return bool(still <= STILL * limit and moving > MOVING * limit)


def pardoned(
    time: Samples, samples: Samples, found: NDArray[np.bool_], limit: float
) -> NDArray[np.bool_]:
    """Without the samples that only stood beside a spike: they agree with what is left."""
    found = found.copy()
    for at in np.flatnonzero(found):
        near = slice(max(at - 3 * REACH, 0), at + 3 * REACH + 1)
        kept = np.where(found[near], np.nan, samples[near])
        kept[at - near.start] = samples[at]
        error = interpolation_errors(time[near], kept)[at - near.start]
        found[at] = abs(error) > limit  # not where nothing is left to compare with
    return found


def alone(found: NDArray[np.bool_], most: int) -> NDArray[np.bool_]:
    """Without crowds of more than `most`: what jumps and stays leaves many in a row."""
    crowd = np.convolve(found, np.ones(CLUSTER), mode="same") > most
    return found & ~(np.convolve(crowd, np.ones(CLUSTER), mode="same") > 0)
