"""The angle of a drop between its samples: the polynomial through the samples around a time."""

from dataclasses import dataclass
from math import factorial

import numpy as np
from numpy.polynomial import polynomial
from numpy.typing import NDArray

from exoid.recordings.landmarks.track import DEGREE, FEWEST, HALF, Track
from exoid.recordings.samples import Samples

ALIKE = 1e-6  # of a window, to which the times of samples are alike: a leg moves 1e-6 rad in it
AT_ONCE = 2**18  # samples of all windows together, so that they stay in the processor's cache


@dataclass(frozen=True, eq=False)
class LocalPolynomials:
    """Polynomials in x = (t - centre) / HALF, one a centre, and how their coefficients err."""

    coefficients: NDArray[np.float64]  # (centre, power)
    covariance: NDArray[np.float64]  # (centre, power, power)

    def derivative(self, order: int, x: Samples | float = 0.0) -> tuple[Samples, Samples]:
        """d^order phi / dt^order at x of each, and their standard errors."""
        row = derivative_row(order, x)
        spread = (self.covariance @ row[..., None])[..., 0]
        return (self.coefficients * row).sum(axis=1), np.sqrt((spread * row).sum(axis=1))

    def value(self, order: int) -> Samples:
        """d^order phi / dt^order at each centre, without its error."""
        return self.coefficients[:, order] * derivative_row(order, 0.0)[order]

    def only(self, number: int) -> "LocalPolynomials":
        """One of them."""
        one = slice(number, number + 1)
        return LocalPolynomials(self.coefficients[one], self.covariance[one])


def derivative_row(order: int, x: Samples | float) -> Samples:
    """What the coefficients (last axis) are multiplied with to give a derivative at x."""
    powers = np.arange(DEGREE + 1)
    factors = [factorial(p) // factorial(p - order) if p >= order else 0 for p in powers.tolist()]
    return (
        np.array(factors) * np.asarray(x)[..., None] ** np.maximum(powers - order, 0) / HALF**order
    )


def local(
    track: Track, centre: Samples, begin: float = -np.inf, half: float = HALF
) -> LocalPolynomials:
    """Through the samples `half` s around each `centre` [s] that are not before `begin`."""
    size = track.time.size
    first = np.searchsorted(track.time, np.maximum(centre - half, begin))
    last = np.searchsorted(track.time, centre + half, side="right")
    first = np.minimum(first, np.maximum(last - FEWEST, 0))
    last = np.maximum(last, np.minimum(first + FEWEST, size))
    widest = int((last - first).max())
    pieces = np.array_split(np.arange(centre.size), -(-centre.size * widest // AT_ONCE))
    each = [through(track, centre[at], first[at], last[at], half) for at in pieces]
    return LocalPolynomials(*map(np.concatenate, zip(*each, strict=True)))


def through(
    track: Track, centre: Samples, first: NDArray[np.int_], last: NDArray[np.int_], half: float
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Coefficients and their covariance, by the normal equations of each window: in units of
    `half` they lose few digits. Windows whose samples lie alike share them.
    """
    at = first[:, None] + np.arange((last - first).max())
    inside = at < last[:, None]
    at = np.minimum(at, track.time.size - 1)
    x = np.where(inside, (track.time[at] - centre[:, None]) / half, np.inf)
    angle = np.where(inside, track.angle[at], 0.0)
    own, which = unlike(x)
    table = polynomial.polyvander(np.where(inside[own], x[own], 0.0), DEGREE)
    table *= inside[own][:, :, None]
    unit = (HALF / half) ** np.arange(DEGREE + 1)
    inverse = np.linalg.inv(np.swapaxes(table, 1, 2) @ table) * np.outer(unit, unit)
    hat = inverse @ np.swapaxes(table / unit, 1, 2)
    coefficients = (hat[which] @ angle[..., None])[..., 0] if own.size > 1 else angle @ hat[0].T
    return coefficients, track.noise**2 * inverse[which]


def unlike(x: NDArray[np.float64]) -> tuple[NDArray[np.int_], NDArray[np.int_]]:
    """Rows that stand for all, and which of them stands for each: those that are the middle one's
    like, and every other for itself.
    """
    middle = x.shape[0] // 2
    with np.errstate(invalid="ignore"):  # where neither has a sample
        alike = ~(np.abs(x - x[middle]) > ALIKE).any(axis=1)
    which = np.where(alike, 0, np.cumsum(~alike))
    return np.concatenate([[middle], np.flatnonzero(~alike)]), which
