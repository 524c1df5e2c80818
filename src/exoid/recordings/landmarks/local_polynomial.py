"""The angle of a drop between its samples: the polynomial through the samples around a time."""

from dataclasses import dataclass, replace
from functools import lru_cache
from math import perm

import numpy as np
from numpy.typing import NDArray

from exoid.recordings.landmarks.track import DEGREE, FEWEST, HALF, Track
from exoid.recordings.measured.samples import Samples

ALIKE = 1e-6  # of a window, to which the times of samples are alike: a leg moves 1e-6 rad in it
AT_ONCE = 2**18  # samples of all windows together, so that they stay in the processor's cache


@dataclass(frozen=True, eq=False)
class LocalPolynomials:
    """Polynomials in x = (t - centre) / HALF, one a centre, and how their coefficients err."""

    coefficients: NDArray[np.float64]  # (centre, power)
    covariance: NDArray[np.floating]  # (kind of window, power, power)
    kind: NDArray[np.int_]  # (centre)

    def derivative(self, order: int, x: Samples | float = 0.0) -> tuple[Samples, Samples]:
        """d^order phi / dt^order at x of each, and their standard errors."""
        row = derivative_row(order, x)
        spread = (self.covariance[self.kind] @ row[..., None])[..., 0]
        return (self.coefficients * row).sum(axis=1), np.sqrt((spread * row).sum(axis=1))

    def value(self, order: int) -> Samples:
        """d^order phi / dt^order at each centre, without its error."""
        return self.coefficients[:, order] * factors(order)[order]

    def believing(self, order: int, value: Samples, error: Samples) -> "LocalPolynomials":
        """The same, whose derivative at each centre is believed to be a value within an error."""
        row = derivative_row(order, 0.0)
        spread = self.covariance[self.kind] @ row
        gain = spread / (spread @ row + error**2)[:, None]
        moved = gain * (value - self.value(order))[:, None]
        left = self.covariance[self.kind] - gain[:, :, None] * spread[:, None, :]
        return LocalPolynomials(self.coefficients + moved, left, np.arange(value.size))

    def only(self, number: int) -> "LocalPolynomials":
        """One of them."""
        one = slice(number, number + 1)
        return LocalPolynomials(self.coefficients[one], self.covariance, self.kind[one])


@lru_cache
def factors(order: int) -> Samples:
    """What stands before the powers of x in a derivative by time of 1, x, x^2 and so on."""
    return np.array([perm(power, order) for power in range(DEGREE + 1)]) / HALF**order


def derivative_row(order: int, x: Samples | float) -> Samples:
    """What the coefficients (last axis) are multiplied with to give a derivative at x."""
    x = np.asarray(x)
    row = np.zeros((*x.shape, DEGREE + 1))
    row[..., order] = 1.0
    for power in range(order + 1, DEGREE + 1):
        np.multiply(row[..., power - 1], x, out=row[..., power])
    return row * factors(order)


def local(
    track: Track, centre: Samples, begin: float = -np.inf, half: float = HALF
) -> LocalPolynomials:
    """Through the samples `half` s around each `centre` [s] that are not before `begin`."""
    first, last = windows(track, centre, begin, half)
    size = max(AT_ONCE // int((last - first).max()), 1)
    parts = [slice(begin, begin + size) for begin in range(0, centre.size, size)]
    each = [through(track, centre[at], first[at], last[at], half) for at in parts]
    return each[0] if len(each) == 1 else joined(each)


def windows(
    track: Track, centre: Samples, begin: float, half: float
) -> tuple[NDArray[np.int_], NDArray[np.int_]]:
    """The first sample of each, and the one after its last."""
    first = np.searchsorted(track.time, np.maximum(centre - half, begin))
    last = np.searchsorted(track.time, centre + half, side="right")
    first = np.minimum(first, np.maximum(last - FEWEST, 0))
    return first, np.maximum(last, np.minimum(first + FEWEST, track.time.size))


def standing(track: Track, centre: Samples, begin: float, half: float) -> LocalPolynomials:
    """As `local`, with errors that hold what samples share that show one code, as about a turn."""
    found, unit = local(track, centre, begin, half), (HALF / half) ** np.arange(DEGREE + 1)
    covariance = found.covariance[found.kind]
    each = zip(covariance, centre, *windows(track, centre, begin, half), strict=True)
    for own, at, first, last in each:
        x = (track.time[first:last] - at) / half
        weights = np.linalg.pinv(np.vander(x, DEGREE + 1, increasing=True)) * unit[:, None]
        own += track.rounded(weights, slice(first, last))
    return replace(found, covariance=covariance, kind=np.arange(centre.size))


def joined(each: list[LocalPolynomials]) -> LocalPolynomials:
    before = np.cumsum([0, *(one.covariance.shape[0] for one in each)])
    return LocalPolynomials(
        np.concatenate([one.coefficients for one in each]),
        np.concatenate([one.covariance for one in each]),
        np.concatenate([one.kind + so_far for one, so_far in zip(each, before, strict=False)]),
    )


def through(
    track: Track, centre: Samples, first: NDArray[np.int_], last: NDArray[np.int_], half: float
) -> LocalPolynomials:
    """By the normal equations of each window: in units of `half` they lose few digits. Windows
    whose samples lie alike share them.
    """
    begin = (track.time[first] - centre) / half
    own, kind = kinds(begin, last - first, float(track.uneven / half))
    at = first[:, None] + np.arange((last - first).max())
    inside = at < last[:, None]
    at = np.minimum(at, track.time.size - 1)
    angle = np.where(inside, track.angle[at], 0.0)
    inside = inside[own]
    x = np.where(inside, (track.time[at[own]] - centre[own, None]) / half, 0.0)
    table = np.empty((own.size, DEGREE + 1, x.shape[1]))
    table[:, 0] = inside
    for power in range(DEGREE):
        np.multiply(table[:, power], x, out=table[:, power + 1])
    inverse = np.linalg.inv(table @ np.swapaxes(table, 1, 2))
    unit = (HALF / half) ** np.arange(DEGREE + 1)
    hat = inverse @ table * unit[:, None]
    coefficients = np.einsum("cps,cs->cp", hat[kind], angle) if own.size > 1 else angle @ hat[0].T
    return LocalPolynomials(coefficients, track.noise**2 * inverse * np.outer(unit, unit), kind)


def kinds(
    begin: Samples, count: NDArray[np.int_], uneven: float
) -> tuple[NDArray[np.int_], NDArray[np.int_]]:
    """Windows that stand for all, and which of them stands for each: one for those that begin alike
    and have as many samples; every one for itself where steps are not alike.
    """
    if begin.size == 1 or uneven * count.max() > ALIKE:
        return np.arange(begin.size), np.arange(begin.size)
    each = count + 1j * np.round(begin / ALIKE)
    _, own, kind = np.unique(each, return_index=True, return_inverse=True)
    return own, kind
