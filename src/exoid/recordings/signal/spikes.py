"""Wild samples: which of a signal are none of its motion."""

import numpy as np
from numpy.typing import NDArray

from exoid.recordings.measured.samples import FAR, Samples, quantum, robust_deviation
from exoid.recordings.measured.segment import Segment
from exoid.recordings.remembered import remembered
from exoid.recordings.signal.excursions import find_excursions
from exoid.recordings.signal.neighbours import NEIGHBOURS, departures, interpolation_errors, renew

ANGLES = ("angle", "raw_angle")
REACH = 2 * NEIGHBOURS + 1
NEAR = 3 * REACH  # samples, within which neighbours speak for one
SMALLEST = 1e-3  # rad or rad/s, of a spike: smaller ones change nothing, and a release has them
CLUSTER = 5  # samples, among which more than one spike are no spikes but an event
LEAPS = 4.0  # times the greatest step beside it, of an angle that leaps at an end
SMALLEST_LEAP = np.radians(2.0)  # of an angle, at an end or to a value that others leap to
FEWEST_ALIKE = 3  # wild samples at one value
ROUNDS = 30  # each takes the worst sample of every neighbourhood
STILL, MOVING = 1.0, 2.0  # range of seven samples, over what a spike departs by at least


@remembered  # asked when a recording is cleaned, and again when it is searched for its movements
def spikes_of(segment: Segment, channel: str, least: float) -> NDArray[np.bool_]:
    """`wild_samples` of a channel by its name."""
    return wild_samples(channel, segment.time, getattr(segment, channel), least)


def wild_samples(
    channel: str, time: Samples, samples: Samples, least: float = 0.0
) -> NDArray[np.bool_]:
    """Those that stand alone, and of an angle those that leap aside together and come back."""
    found = find_spikes(time, samples, least)
    if channel not in ANGLES:
        return found
    found |= at_ends(np.where(found, np.nan, samples))
    found |= at_one_value(samples, found)
    rest = np.where(found, np.nan, samples)
    return found | find_excursions(time, rest, max(least, quantum([samples]) / np.sqrt(12)))


def at_ends(angle: Samples) -> NDArray[np.bool_]:
    """Which of the first and of the last known samples, too few for `find_spikes`, an angle [rad]
    leaps to, beside the steps that it makes there.
    """
    known, found = np.flatnonzero(~np.isnan(angle)), np.zeros(angle.size, dtype=bool)
    for inwards in (known, known[::-1]):
        kept = angle[inwards[NEIGHBOURS : NEIGHBOURS + REACH]]
        steps = np.abs(np.diff(kept))
        for at in inwards[:NEIGHBOURS][::-1] if steps.size else ():
            step = abs(angle[at] - kept[0])
            found[at] = step > max(SMALLEST_LEAP, LEAPS * steps.max())
            if not found[at]:
                kept, steps = np.append(angle[at], kept), np.append(step, steps)
    return found


def at_one_value(angle: Samples, found: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Which samples of an angle [rad] are at the value that most of those found are at, as where a
    logger writes 0 for what it does not hear: also in crowds, where all beside is on one side.
    """
    values, counts = np.unique(angle[found], return_counts=True)
    if counts.max(initial=0) < max(FEWEST_ALIKE, found.sum() / 2):
        return np.zeros(angle.size, dtype=bool)
    places, value = np.arange(angle.size), values[counts.argmax()]
    rest = np.flatnonzero(~(np.isnan(angle) | found | (angle == value)))
    if not rest.size:
        return np.zeros(angle.size, dtype=bool)
    after = np.searchsorted(rest, places).clip(1, rest.size - 1)
    before, behind = (angle[rest[each]] - value for each in (after - 1, after))
    beyond = (np.minimum(before, behind) > SMALLEST_LEAP) | (
        np.maximum(before, behind) < -SMALLEST_LEAP
    )
    return beyond & (angle == value)


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
    single, found = alone(found, 1), alone(found, 2)
    for at in np.flatnonzero(found):
        before, after = kept[max(at - REACH, 0) : at], kept[at + 1 : at + 1 + REACH]
        if not stands_out(samples[at], before, after, limit):
            found[at] = single[at] and not begins_or_ends(before, after, limit)
        near = slice(max(at - REACH, 0), at + 1 + REACH)
        found[at] &= not is_tip(time[near] - time[at], kept[near], samples[at], limit)
    return found


def is_tip(since: Samples, kept: Samples, sample: float, limit: float) -> bool:
    """Does it go no farther than the lines that run into it, as where a leg meets a stop? `since`
    is 0 at the sample, and `kept` are those that no spike is among.
    """
    known = np.flatnonzero(~np.isnan(kept))
    after = int(np.searchsorted(since[known], 0.0))
    if not 2 <= after <= known.size - 2:
        return False
    (a, b), (c, d) = known[after - 2 : after], known[after : after + 2]
    side = np.sign(kept[b] + kept[c] - 2 * sample)  # 1 where it is below those beside it
    left, right = (
        kept[near] - since[near] * (kept[far] - kept[near]) / (since[far] - since[near])
        for near, far in ((b, a), (c, d))
    )
    return bool(side * sample > max(side * left, side * right) - limit)


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
    """Without the samples that only stood beside a spike: they agree with what is left.

    One after the other, for who is pardoned speaks for the next: the first of every crowd at once,
    then the second.
    """
    places, missing = np.flatnonzero(found), np.isnan(samples)
    number = np.arange(places.size)
    begins = np.concatenate([[True], np.diff(places) > NEAR])
    turn = number - np.maximum.accumulate(np.where(begins, number, 0))
    left = found.copy()
    for each in range(int(turn.max()) + 1):
        at, known = places[turn == each], np.flatnonzero(~(left | missing))
        left[at] = False  # also where nothing near is left to compare with
        after = np.searchsorted(known, at)
        told = (after >= NEIGHBOURS) & (after <= known.size - NEIGHBOURS)
        at, near = at[told], known[after[told] + np.arange(-NEIGHBOURS, NEIGHBOURS)[:, None]]
        wild = np.abs(departures(time, samples, at, near)) > limit
        left[at] = wild & (near[0] >= at - NEAR) & (near[-1] <= at + NEAR)
    return left


def alone(found: NDArray[np.bool_], most: int) -> NDArray[np.bool_]:
    """Without crowds of more than `most`: what jumps and stays leaves many in a row."""
    crowd = np.convolve(found, np.ones(CLUSTER), mode="same") > most
    return found & ~(np.convolve(crowd, np.ones(CLUSTER), mode="same") > 0)
