"""By how much samples depart from what their neighbours say, which sees noise and no motion."""

import numpy as np
from numpy.typing import NDArray

from exoid.recordings.samples import Samples

NEIGHBOURS = 3  # on either side: a quintic, from which a leg departs by 1e-5 rad even at 30 Hz
OFFSETS = [offset for offset in range(-NEIGHBOURS, NEIGHBOURS + 1) if offset]
EVENLY = (0.05, -0.3, 0.75, 0.75, -0.3, 0.05)  # of each in the quintic, evenly apart
ALIKE = 1e-7  # of a step, to which neighbours are evenly apart: a leg moves 1e-8 rad in it


def interpolation_errors(
    time: Samples, samples: Samples, stride: int = 1, most: int | None = None
) -> Samples:
    """By how much every sample departs from the quintic through its three known neighbours on
    either side, `stride` samples apart, scaled to scatter as the noise does.

    nan for missing samples, for those at either end, and where there are too few; with `most`, for
    all but about so many, evenly taken.
    """
    known = np.flatnonzero(~np.isnan(samples))
    errors = np.full(samples.size, np.nan)
    reach = NEIGHBOURS * stride
    if known.size <= 2 * reach:
        return errors
    clock, values = (time, samples) if known.size == samples.size else (time[known], samples[known])
    inner = slice(reach, known.size - reach)
    inner = slice(
        inner.start, inner.stop, max((inner.stop - inner.start) // most, 1) if most else 1
    )
    departure = values[inner].copy()
    for offset, weight in zip(OFFSETS, EVENLY, strict=True):
        departure -= weight * values[beside(inner, offset * stride)]
    departure /= np.sqrt(1 + np.square(EVENLY).sum())
    steps = np.diff(clock)
    changes = np.abs(np.diff(steps)) > ALIKE * steps[1:]
    if changes.any():
        changes = np.concatenate([[0], np.cumsum(changes)])
        off = changes[beside(inner, reach - 1)] > changes[beside(inner, -reach)]
        middle = np.arange(known.size)[inner][off]
        departure[off] = departures(clock, values, middle, stride)
    errors[known[inner]] = departure
    return errors


def beside(inner: slice, lag: int) -> slice:
    """The same samples, so many later."""
    return slice(inner.start + lag, inner.stop + lag, inner.step)


def departures(
    clock: Samples, values: Samples, middle: NDArray[np.int_], stride: int = 1
) -> Samples:
    """`interpolation_errors` of some samples, however their neighbours are apart."""
    near = middle + np.array(OFFSETS)[:, None] * stride
    lags = clock[near] - clock[middle]
    weights = np.ones_like(lags)
    for one, weight in enumerate(weights):
        for other, lag in enumerate(lags):
            if one != other:
                weight *= lag / (lag - lags[one])
    missed = values[middle] - np.sum(weights * values[near], axis=0)
    return missed / np.sqrt(1 + np.sum(weights**2, axis=0))


def renew(errors: Samples, time: Samples, samples: Samples, gone: NDArray[np.int_]) -> None:
    """The errors of a signal that some samples are `gone` from, in place: only their neighbours'
    are others.
    """
    known = np.flatnonzero(~np.isnan(samples))
    places = np.searchsorted(known, gone)[:, None] + np.arange(-NEIGHBOURS, NEIGHBOURS)
    places = np.unique(np.clip(places, 0, known.size - 1))
    errors[gone] = errors[known[places]] = np.nan
    told = places[(places >= NEIGHBOURS) & (places < known.size - NEIGHBOURS)]
    errors[known[told]] = departures(time[known], samples[known], told)
