"""Where a derivative of a drop's angle is greatest or least."""

import numpy as np
from numpy.polynomial import polynomial

from exoid.recordings.landmarks.local_polynomial import local
from exoid.recordings.landmarks.track import HALF, Peak, Track, nearest
from exoid.recordings.samples import Samples

BLURRED = 0.005  # s of error in time from which on an extreme is looked for more widely


def peak(track: Track, near: int, order: int = 0, begin: float = -np.inf) -> Peak:
    """The extreme of a derivative next to the track's sample `near`, else its value there.

    Where noise blurs it, a polynomial over twice the time is taken.
    """
    sharp = stationary(track, near, order, begin, HALF)
    blurred = sharp.time_error >= BLURRED
    return stationary(track, near, order, begin, 2 * HALF) if blurred else sharp


def stationary(track: Track, near: int, order: int, begin: float, half: float) -> Peak:
    centre = track.time[[near]]
    found = local(track, centre, begin, half)
    x = extreme(found.coefficients[0], order)
    value, error = found.derivative(order, x)
    slope_error = float(found.derivative(order + 1, x)[1][0])
    bend = float(found.derivative(order + 2, x)[0][0])
    time_error = slope_error / abs(bend) if bend else HALF
    time = float(centre[0]) + HALF * x
    return Peak(nearest(track, time), time, min(time_error, HALF), float(value[0]), float(error[0]))


def extreme(coefficients: Samples, order: int) -> float:
    """The x nearest to 0 at which a derivative has an extreme; 0 where it has none near."""
    roots = polynomial.polyroots(polynomial.polyder(coefficients, order + 1))
    real = roots[np.abs(roots.imag) < 1e-9].real
    near = real[np.abs(real) <= 0.5]  # farther out, another polynomial follows the curve better
    return float(near[np.argmin(np.abs(near))]) if near.size else 0.0
