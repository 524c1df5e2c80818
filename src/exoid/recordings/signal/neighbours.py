"""By how much samples depart from what their neighbours say, which sees noise and no motion."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

NEIGHBOURS = 3  # on either side: a quintic, from which a leg departs by 1e-5 rad even at 30 Hz
OFFSETS = [offset for offset in range(-NEIGHBOURS, NEIGHBOURS + 1) if offset]
EVENLY = np.array([-0.05, 0.3, -0.75, 1.0, -0.75, 0.3, -0.05])  # less the quintic, evenly apart
DEPARTURE = EVENLY / np.linalg.norm(EVENLY)  # scatters as the noise does
ALIKE = 1e-7  # of a step, to which neighbours are evenly apart: a leg moves 1e-8 rad in it

Samples = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Known:
    """The known samples of a signal, and how many changes of the step come before each."""

    places: NDArray[np.int_]
    time: Samples  # s
    values: Samples
    changes: NDArray[np.int_] | None  # None where the step never changes

    def errors(self, stride: int = 1, most: int | None = None) -> tuple[slice, Samples]:
        """Those of `interpolation_errors` that are told, and which of the known samples they are
        of. None where there are too few.
        """
        reach = NEIGHBOURS * stride
        inside = max(self.places.size - 2 * reach, 0)
        inner = slice(reach, reach + inside, max(inside // most, 1) if most else 1)
        if inside and inner.step == stride == 1:
            departure = np.correlate(self.values, DEPARTURE, "valid")
        else:
            departure = DEPARTURE[NEIGHBOURS] * self.values[inner]
            for offset in OFFSETS if inside else ():
                weight = DEPARTURE[NEIGHBOURS + offset]
                departure += weight * self.values[beside(inner, offset * stride)]
        if self.changes is not None and inside:
            off = self.changes[beside(inner, reach - 1)] > self.changes[beside(inner, -reach)]
            middle = np.arange(self.places.size)[inner][off]
            near = middle + np.array(OFFSETS)[:, None] * stride
            departure[off] = departures(self.time, self.values, middle, near)
        return inner, departure


def known_of(time: Samples, samples: Samples) -> Known:
    missing = np.isnan(samples)
    places = np.flatnonzero(~missing)
    if missing.any():
        time, samples = time[places], samples[places]
    steps = np.diff(time)
    changes = np.abs(np.diff(steps)) > ALIKE * steps[1:]
    counted = np.concatenate([[0], np.cumsum(changes)]) if changes.any() else None
    return Known(places, time, samples, counted)


def interpolation_errors(time: Samples, samples: Samples) -> Samples:
    """By how much every sample departs from the quintic through its three known neighbours on
    either side, scaled to scatter as the noise does.

    nan for missing samples, for those at either end, and where there are too few.
    """
    known = known_of(time, samples)
    inner, told = known.errors()
    errors = np.full(samples.size, np.nan)
    errors[known.places[inner]] = told
    return errors


def beside(inner: slice, lag: int) -> slice:
    """The same samples, so many later."""
    return slice(inner.start + lag, inner.stop + lag, inner.step)


def departures(
    clock: Samples, values: Samples, middle: NDArray[np.int_], near: NDArray[np.int_]
) -> Samples:
    """`interpolation_errors` of some samples beside those that are `near` (neighbour, sample),
    however they are apart.
    """
    lags = clock[near] - clock[middle]
    weights = np.empty_like(lags)
    for one, lag in enumerate(lags):
        away = lags - lag
        away[one] = lag
        np.multiply.reduce(lags / away, axis=0, out=weights[one])
    missed = values[middle] - np.sum(weights * values[near], axis=0)
    return missed / np.sqrt(1 + np.sum(weights**2, axis=0))


def jumps_of(known: Known, size: float, apart: float) -> NDArray[np.int_] | None:
    """How many samples up to each are beside a jump by more than a `size`; None where there is
    none, or where they are less than so many seconds `apart`, as the steps of an interpolation are.
    """
    inner, errors = known.errors()
    near = inner.start + np.flatnonzero(np.abs(errors) > size)
    count = np.sum(np.diff(near, prepend=-np.inf) > 2 * NEIGHBOURS)
    if not count or count * apart > known.time[-1] - known.time[0]:
        return None
    return np.cumsum(np.bincount(near, minlength=known.time.size))


def astride(jumps: NDArray[np.int_] | None, inner: slice, reach: int) -> NDArray[np.bool_]:
    """Which of the inner samples have neighbours, as far as they reach, on both sides of a jump."""
    if jumps is None:
        return np.zeros(len(range(*inner.indices(inner.stop))), bool)
    return jumps[beside(inner, reach)] > jumps[beside(inner, -reach)]


def renew(errors: Samples, time: Samples, samples: Samples, gone: NDArray[np.int_]) -> None:
    """The errors of a signal that some samples are `gone` from, in place: only their neighbours'
    are others.
    """
    known = np.flatnonzero(~np.isnan(samples))
    places = np.searchsorted(known, gone)[:, None] + np.arange(-NEIGHBOURS, NEIGHBOURS)
    places = np.unique(np.clip(places, 0, known.size - 1))
    errors[gone] = errors[known[places]] = np.nan
    told = places[(places >= NEIGHBOURS) & (places < known.size - NEIGHBOURS)]
    near = known[told + np.array(OFFSETS)[:, None]]
    errors[known[told]] = departures(time, samples, known[told], near)
