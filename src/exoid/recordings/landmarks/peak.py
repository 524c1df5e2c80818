"""Where a drop's angle, or a derivative of it, is greatest or least."""

import numpy as np
from numpy.typing import NDArray

from exoid.recordings.landmarks.local_polynomial import DEGREE, LocalPolynomials, standing
from exoid.recordings.landmarks.track import HALF, Peak, Track, nearest
from exoid.recordings.samples import Samples

BLURRED = 0.005  # s of error in time from which on an extreme is looked for more widely
NEAR = 0.5  # of HALF: farther out, another polynomial follows the curve better
SURE_SLOPE = 2.0  # errors of a slope, from which on an extreme is elsewhere
TRIED = np.linspace(-NEAR, NEAR, 101)  # of HALF, where it may be: a thousandth of a second apart
LEAST = 1e-12  # of the greatest coefficient: a smaller one moves no extreme that is near


def peaks(track: Track, near: list[int], begin: float = -np.inf) -> list[Peak]:
    """The extremes next to the track's samples `near`, else the angles there.

    Where noise blurs one, a polynomial over twice the time is taken.
    """
    sharp = stationary(track, near, begin, HALF)
    blurred = [at for at, each in zip(near, sharp, strict=True) if each.time_error >= BLURRED]
    wide = dict(zip(blurred, stationary(track, blurred, begin, 2 * HALF), strict=True))
    return [wide.get(at, each) for at, each in zip(near, sharp, strict=True)]


def stationary(track: Track, near: list[int], begin: float, half: float) -> list[Peak]:
    if not near:
        return []
    centre = track.time[near]
    found = standing(track, centre, begin, half)
    x = extremes(found.coefficients)
    value, error = found.derivative(0, x)
    slope_error, bend = found.derivative(1, x)[1], np.abs(found.derivative(2, x)[0])
    time_error = np.divide(slope_error, bend, out=np.full(x.size, HALF), where=bend > 0)
    times = centre + HALF * x
    each = zip(*(one.tolist() for one in (times, time_error, value, error)), strict=True)
    return [
        Peak(nearest(track, time), time, min(late, HALF), angle, unsure)
        for time, late, angle, unsure in each
    ]


def extremes(coefficients: NDArray[np.float64]) -> Samples:
    """Of every polynomial the x nearest to 0 at which it has an extreme; 0 where none is near."""
    slopes = coefficients[:, 1:] * np.arange(1, DEGREE + 1)
    size = np.abs(slopes).max(axis=1, initial=0.0)
    least = np.where(size > 0, LEAST * size, 1.0)
    highest = np.where(np.abs(slopes[:, -1]) > least, slopes[:, -1], least)
    companion = np.zeros((size.size, DEGREE - 1, DEGREE - 1))
    companion[:, 1:, :-1] = np.eye(DEGREE - 2)
    companion[:, :, -1] = -slopes[:, :-1] / highest[:, None]
    roots = np.linalg.eigvals(companion)
    seen = (np.abs(roots.imag) < 1e-9) & (np.abs(roots.real) <= NEAR)
    away = np.where(seen, np.abs(roots.real), np.inf)
    closest = np.take_along_axis(roots.real, away.argmin(axis=1)[:, None], axis=1)[:, 0]
    return np.where(seen.any(axis=1), closest, 0.0)


def fastest(place: LocalPolynomials, sign: int) -> tuple[float, float, float]:
    """Where the angular velocity by one polynomial is greatest (sign 1) or least (-1): s from its
    centre, rad/s, standard error.

    At the centre, unless it surely still grows there, as beside a short peak. Such a peak may be
    higher than a polynomial follows: half of what it gains is in the error.
    """
    slope, unsure = (float(each[0]) for each in place.derivative(2))
    values, errors = place.derivative(1, TRIED)
    middle = TRIED.size // 2
    at = int(np.argmax(sign * values)) if abs(slope) > SURE_SLOPE * unsure else middle
    gained = float(values[at] - values[middle])
    return HALF * float(TRIED[at]), float(values[at]), float(np.hypot(errors[at], gained / 2))
