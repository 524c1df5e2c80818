"""The angle of a drop between its samples: local polynomials, their derivatives and extremes."""

from dataclasses import dataclass
from math import factorial

import numpy as np
from numpy.polynomial import polynomial
from numpy.typing import NDArray

from exoid.recordings.landmarks.measure import Mark, NotAllowed
from exoid.recordings.recording import Segment
from exoid.recordings.samples import Samples

HALF = 0.1  # s to either side that a polynomial follows, a tenth of a leg's swing
DEGREE = 4  # the middle of a swing is then followed to 1 in 2000, its acceleration included
BLURRED = 0.005  # s of error in time from which on an extreme is looked for more widely
SURE = 3.0  # standard errors
FEWEST = DEGREE + 2  # samples of a polynomial
SLOWEST = 0.034  # s between samples: of a slower recording, a window would be a third of a swing


@dataclass(frozen=True)
class Peak:
    """An extreme, or another place on the curve, with its errors."""

    sample: int  # of the segment, the nearest
    time: float  # s
    time_error: float  # s
    value: float  # rad, rad/s or rad/s^2
    error: float

    @property
    def mark(self) -> Mark:
        return Mark(self.sample, self.time, self.value)


@dataclass(frozen=True, eq=False)
class Track:
    """The angle of a drop where it was measured."""

    sample: NDArray[np.int_]  # in the segment
    time: Samples  # s, on the segment's clock
    angle: Samples  # rad
    noise: float  # rad, white, of one sample

    def smoothed_noise(self, width: float) -> float:
        """What of it is left [rad] in straight lines over `width` s."""
        return self.noise / np.sqrt(max(width / float(np.median(np.diff(self.time))), 3.0))


@dataclass(frozen=True, eq=False)
class LocalPolynomial:
    """A polynomial in x = (t - centre) / HALF, and the covariance of its coefficients."""

    centre: float  # s
    coefficients: Samples
    covariance: NDArray[np.float64]

    def derivative(self, order: int, x: float = 0.0) -> tuple[float, float]:
        """d^order phi / dt^order at x, and its standard error."""
        row = derivative_row(order, x)
        return float(row @ self.coefficients), float(np.sqrt(row @ self.covariance @ row))


def track_of(segment: Segment, noise: float) -> Track:
    """The encoder's angle, or the filtered one where there is no other.

    **Raises** `NotAllowed` where it is sampled too slowly, or interrupted.
    """
    sample = np.flatnonzero(~np.isnan(segment.best_angle))
    time = segment.time[sample]
    if time.size < FEWEST:
        raise NotAllowed(f"too short: it holds {time.size} samples of the angle")
    steps = np.diff(time)
    if np.median(steps) > SLOWEST:
        raise NotAllowed(
            f"sampled too slowly: at {1 / np.median(steps):.3g} Hz, 30 Hz are the least"
        )
    if steps.max() > HALF:
        at = int(np.argmax(steps))
        raise NotAllowed(
            f"interrupted: no angle was measured from {time[at]:.2f} to {time[at + 1]:.2f} s"
        )
    return Track(sample, time, segment.best_angle[sample], noise)


def derivative_row(order: int, x: float) -> Samples:
    """What the coefficients are multiplied with to give a derivative at x."""
    powers = np.arange(DEGREE + 1)
    factors = [factorial(p) // factorial(p - order) if p >= order else 0 for p in powers.tolist()]
    return np.array(factors) * x ** np.maximum(powers - order, 0) / HALF**order


def local(
    track: Track, centre: float, begin: float = -np.inf, half: float = HALF
) -> LocalPolynomial:
    """The polynomial through the samples `half` s around `centre` that are not before `begin`."""
    time = track.time
    first = int(np.searchsorted(time, max(centre - half, begin)))
    last = int(np.searchsorted(time, centre + half, side="right"))
    first = min(first, max(last - FEWEST, 0))
    last = max(last, min(first + FEWEST, time.size))
    x = (time[first:last] - centre) / HALF
    q, r = np.linalg.qr(polynomial.polyvander(x, DEGREE))
    inverse = np.linalg.inv(r)
    coefficients = inverse @ (q.T @ track.angle[first:last])
    return LocalPolynomial(centre, coefficients, track.noise**2 * inverse @ inverse.T)


def peak(track: Track, near: int, order: int = 0, begin: float = -np.inf) -> Peak:
    """The extreme of a derivative next to the track's sample `near`, else its value there.

    Where noise blurs it, a polynomial over twice the time is taken.
    """
    sharp = stationary(track, near, order, begin, HALF)
    blurred = sharp.time_error >= BLURRED
    return stationary(track, near, order, begin, 2 * HALF) if blurred else sharp


def stationary(track: Track, near: int, order: int, begin: float, half: float) -> Peak:
    found = local(track, float(track.time[near]), begin, half)
    x = extreme(found.coefficients, order)
    value, error = found.derivative(order, x)
    _, slope_error = found.derivative(order + 1, x)
    bend, _ = found.derivative(order + 2, x)
    time_error = slope_error / abs(bend) if bend else HALF
    time = found.centre + HALF * x
    return Peak(nearest(track, time), time, min(time_error, HALF), value, error)


def extreme(coefficients: Samples, order: int) -> float:
    """The x nearest to 0 at which a derivative has an extreme; 0 where it has none near."""
    roots = polynomial.polyroots(polynomial.polyder(coefficients, order + 1))
    real = roots[np.abs(roots.imag) < 1e-9].real
    near = real[np.abs(real) <= 0.5]  # farther out, another polynomial follows the curve better
    return float(near[np.argmin(np.abs(near))]) if near.size else 0.0


def nearest(track: Track, time: float) -> int:
    """The sample of the segment that is nearest to a time."""
    return int(track.sample[np.argmin(np.abs(track.time - time))])
