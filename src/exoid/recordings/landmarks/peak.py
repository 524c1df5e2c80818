"""Where a drop's angle, or a derivative of it, is greatest or least."""

import numpy as np
from numpy.typing import NDArray

from exoid.recordings.landmarks.local_polynomial import DEGREE, LocalPolynomials, standing
from exoid.recordings.landmarks.track import HALF, SURE, Peak, Track, nearest
from exoid.recordings.measured.samples import Samples

BLURRED = 0.005  # s of error in time from which on an extreme is looked for more widely
NEAR = 0.5  # of a polynomial: farther out, another polynomial follows the curve better
SHARE = 0.5  # to which a swing shrinks whose next is not seen
UNSURE = 0.4  # of how much a turn bends by the swings beside it
RATE = 6.0  # rad/s, at which a leg swings, about
SURE_SLOPE = 2.0  # errors of a slope, from which on an extreme is elsewhere
TRIED = np.linspace(-NEAR, NEAR, 101)  # of HALF, where it may be: a thousandth of a second apart
LEAST = 1e-12  # of the greatest coefficient: a smaller one moves no extreme that is near


def peaks(
    track: Track, near: list[int], begin: float = -np.inf, bends: Samples | None = None
) -> list[Peak]:
    """The extremes next to the track's samples `near`, else the angles there.

    Where noise blurs one, a polynomial over twice the time is taken. Each is believed to bend about
    as much as `bends` [rad/s^2], by default as the swings beside it: noise bends one far more that
    is small.
    """
    if bends is None:
        found = either(track, near, begin, None)
        bends = bends_of(found)
        if bends is None:
            return found
    return either(track, near, begin, bends)


def either(track: Track, near: list[int], begin: float, bends: Samples | None) -> list[Peak]:
    """By polynomials over the usual time, or over twice as much where noise blurs that."""
    found = stationary(track, near, begin, HALF, bends)
    blurred = [at for at, each in enumerate(found) if each.time_error >= BLURRED]
    those = None if bends is None else bends[blurred]
    wide = stationary(track, [near[at] for at in blurred], begin, 2 * HALF, those)
    better = dict(zip(blurred, wide, strict=True))
    return [better.get(at, each) for at, each in enumerate(found)]


def bends_of(turns: list[Peak]) -> Samples | None:
    """How much the angle of a swing that shrinks by a factor bends at its turns [rad/s^2]: the
    second derivative of what goes by so much from each to the next; None of fewer than two.
    """
    if len(turns) < 2:
        return None
    ways = np.diff([each.value for each in turns])
    lasting = float(np.median(np.diff([each.time for each in turns])))
    shares = np.abs(ways[1:] / ways[:-1])
    share = min(float(np.median(shares)), 1.0) if shares.size else SHARE
    after = np.append(ways, -share * ways[-1])
    return (np.pi**2 + np.log(share) ** 2) / lasting**2 * after / (1 + share)


def stationary(
    track: Track, near: list[int], begin: float, half: float, bends: Samples | None = None
) -> list[Peak]:
    if not near:
        return []
    centre = track.time[near]
    found = standing(track, centre, begin, half)
    if bends is not None:
        found = swinging(found, bends)
    x = extremes(found.coefficients, NEAR * half / HALF)
    value, error = found.derivative(0, x)
    slope_error, bend = found.derivative(1, x)[1], np.abs(found.derivative(2, x)[0])
    time_error = np.divide(slope_error, bend, out=np.full(x.size, half), where=bend > 0)
    times = centre + HALF * x
    each = zip(*(one.tolist() for one in (times, time_error, value, error)), strict=True)
    return [
        Peak(nearest(track, time), time, min(late, half), angle, unsure)
        for time, late, angle, unsure in each
    ]


def swinging(found: LocalPolynomials, bends: Samples) -> LocalPolynomials:
    """The polynomials of a swing that turns with such bends [rad/s^2]: b, about 0 and -RATE^2 b are
    its second to fourth derivatives. What surely bends more, as by a reflex or a stop, does.
    """
    bend, unsure = found.derivative(2)
    size = np.maximum(np.abs(bends), np.sign(bends) * bend - SURE * unsure)
    bends = np.sign(bends) * size
    found = found.believing(2, bends, UNSURE * size)
    found = found.believing(3, 0.0 * bends, RATE * size)
    return found.believing(4, -(RATE**2) * bends, RATE**2 * size)


def extremes(coefficients: NDArray[np.float64], reach: float) -> Samples:
    """Of every polynomial the x nearest to 0 at which it has an extreme; 0 where none is within
    `reach`.
    """
    slopes = coefficients[:, 1:] * np.arange(1, DEGREE + 1)
    size = np.abs(slopes).max(axis=1, initial=0.0)
    least = np.where(size > 0, LEAST * size, 1.0)
    highest = np.where(np.abs(slopes[:, -1]) > least, slopes[:, -1], least)
    companion = np.zeros((size.size, DEGREE - 1, DEGREE - 1))
    companion[:, 1:, :-1] = np.eye(DEGREE - 2)
    companion[:, :, -1] = -slopes[:, :-1] / highest[:, None]
    roots = np.linalg.eigvals(companion)
    seen = (np.abs(roots.imag) < 1e-9) & (np.abs(roots.real) <= reach)
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
