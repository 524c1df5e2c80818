"""The angle of a drop between its samples: the polynomial through the samples around a time."""

from dataclasses import dataclass
from math import factorial

import numpy as np
from numpy.polynomial import polynomial
from numpy.typing import NDArray

from exoid.recordings.landmarks.track import DEGREE, FEWEST, HALF, Track
from exoid.recordings.samples import Samples

AT_ONCE = 2**18  # samples of all windows together, so that they stay in the processor's cache


@dataclass(frozen=True, eq=False)
class LocalPolynomials:
    """Polynomials in x = (t - centre) / HALF, one a centre, and how their coefficients err."""

    coefficients: NDArray[np.float64]  # (centre, power)
    covariance: NDArray[np.float64]  # (centre, power, power)

    def derivative(self, order: int, x: float = 0.0) -> tuple[Samples, Samples]:
        """d^order phi / dt^order at x of each, and their standard errors."""
        row = derivative_row(order, x)
        return self.coefficients @ row, np.sqrt(row @ self.covariance @ row)


def derivative_row(order: int, x: float) -> Samples:
    """What the coefficients are multiplied with to give a derivative at x."""
    powers = np.arange(DEGREE + 1)
    factors = [factorial(p) // factorial(p - order) if p >= order else 0 for p in powers.tolist()]
    return np.array(factors) * x ** np.maximum(powers - order, 0) / HALF**order


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
    each = [through(track, centre[at], first[at], last[at]) for at in pieces]
    return LocalPolynomials(*map(np.concatenate, zip(*each, strict=True)))


def through(
    track: Track, centre: Samples, first: NDArray[np.int_], last: NDArray[np.int_]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Coefficients and their covariance, by an orthogonal basis of each window."""
    at = first[:, None] + np.arange((last - first).max())
    inside = at < last[:, None]
    at = np.minimum(at, track.time.size - 1)
    x = np.where(inside, track.time[at] - centre[:, None], 0.0) / HALF
    q, r = np.linalg.qr(polynomial.polyvander(x, DEGREE) * inside[:, :, None])
    inverse = np.linalg.inv(r)
    along = np.einsum("cwp,cw->cp", q, track.angle[at])
    spread = track.noise**2 * inverse @ np.swapaxes(inverse, 1, 2)
    return np.einsum("cpq,cq->cp", inverse, along), spread
