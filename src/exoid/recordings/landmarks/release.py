"""How a leg was let go: when, from which angle, and whether nothing held it any more.

Held still until t0, it then falls from rest:

    phi = phi_s + a x^2 + b x^3 + c x^4 + e x^5,   x = t - t0.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from math import perm

import numpy as np
from numpy.polynomial.legendre import legfit
from numpy.typing import NDArray

from exoid.recordings.landmarks.local_polynomial import local
from exoid.recordings.landmarks.measure import NotAllowed
from exoid.recordings.landmarks.track import HALF, SURE, Peak, Track, nearest
from exoid.recordings.motion.extent import Extent
from exoid.recordings.samples import Samples
from exoid.recordings.signal.condition import MOTION_SPEED
from exoid.recordings.signal.left_over import orthonormal

FALL = 0.3  # s of the fall that are followed
MISSED = 0.05  # of its first acceleration, by what the polynomial leaves out of a quick leg's fall
LATE = 0.025  # s by which the first sample may come after the release
NEAR, LATER = 0.03, 0.03  # s around the release that are tried; play hides the first of a fall
STEP = 0.001  # s between the tried times of release
POWERS = (0, 2, 3, 4, 5)
FEWEST = 8  # samples of the fall

Table = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Release:
    """The start of a fall. `fall` holds phi_s, a, b, c and e, with x in units of FALL."""

    start: Peak  # s, rad
    fall: Samples
    covariance: Table  # of `fall`, with that of t0 behind it

    def derivative(self, order: int, after: Samples) -> tuple[Samples, Samples]:
        """d^order phi / dt^order `after` s into the fall, and their standard errors."""
        rows = fall_row(after / FALL, order) / FALL**order
        error = np.sqrt(np.einsum("ti,ti->t", rows @ self.covariance[:-1, :-1], rows))
        return rows @ self.fall, error

    def steepest(self) -> tuple[float, float, float]:
        """Where its first part accelerates most towards flexion: s after t0, rad/s^2, error."""
        tried = np.linspace(0.0, HALF, 11)
        values, errors = self.derivative(2, tried)
        at = int(np.argmin(values))
        value = float(values[at])
        return float(tried[at]), value, float(np.hypot(errors[at], MISSED * value))


def find_release(track: Track, extent: Extent) -> Release:
    """The release of a drop whose movement is known.

    **Raises** `NotAllowed` where the recording begins after its release.
    """
    begin, lowest, reach = about(track, extent)
    tried = np.arange(max(begin - reach, lowest), begin + reach + LATER, STEP)
    best = float(tried[int(np.argmin(misfits(track, tried)))])
    step = refined(track, best)[1]
    return refined(track, best + float(np.clip(step, -STEP, STEP)))[0]


def about(track: Track, extent: Extent) -> tuple[float, float, float]:
    """Near which time it was let go, before which it was not, and how near [s]: at its first sample
    where that comes later, as at the top to which a rig that was let go below its rest swings.
    """
    first = float(track.time[0])
    if extent.held_until is not None and extent.release > first - LATE:
        return extent.release, first, NEAR + SURE * extent.release_error
    begun, error = (float(each[0]) for each in local(track, track.time[[0]]).derivative(1))
    if abs(begun) > MOTION_SPEED + SURE * error:
        raise NotAllowed(
            f"begins in motion, at {abs(np.degrees(begun)):.0f} deg/s: the release was not "
            "recorded. Hold the leg still for a second before you let go"
        )
    return first, first - LATE, NEAR


def fall_row(x: Samples, order: int = 0) -> Samples:
    """A derivative of 1, x^2, x^3, x^4 and x^5."""
    return np.stack([perm(power, order) * one for power, one in powers_of(x, order)], axis=-1)


def powers_of(x: Samples, less: int = 0) -> Iterator[tuple[int, Samples]]:
    """Each of POWERS, and x to so many `less` than it, by products: a power takes ten times as
    long.
    """
    found, so_far = np.ones_like(x), 0
    for power in POWERS:
        while so_far < power - less:
            found, so_far = found * x, so_far + 1
        yield power, found


def followed(track: Track, begin: Samples) -> tuple[slice, NDArray[np.bool_]]:
    """The samples from a little before a release at each `begin` to the end of what is followed,
    and which of them belong to each.
    """
    time = track.time
    used = slice(*np.searchsorted(time, [begin.min() - FALL, begin.max() + FALL]))
    since = time[used] - begin[:, None]
    inside = (since > -FALL) & (since < FALL)
    if (np.count_nonzero(inside & (since >= 0), axis=1) < FEWEST).any():
        raise NotAllowed(f"cut during the fall: fewer than {FEWEST} samples follow the release")
    return used, inside


def misfits(track: Track, tried: Samples) -> Samples:
    """The sums of squares for each release that is `tried`."""
    used, inside = followed(track, tried)
    x = np.where(inside, np.maximum(track.time[used] - tried[:, None], 0) / FALL, 0.0)
    columns = np.stack([one for _, one in powers_of(x)], axis=1)
    columns[:, 0] = inside
    basis = orthonormal(columns)
    angle = np.where(inside, track.angle[used] - track.angle[used].mean(), 0.0)
    along = (basis @ angle[..., None])[..., 0]
    return (angle**2).sum(axis=1) - (along**2).sum(axis=1)


def refined(track: Track, begin: float) -> tuple[Release, float]:
    """The fall from `begin`, and by how much later [s] a release would fit it best."""
    used, (inside,) = followed(track, np.array([begin]))
    time, angle = track.time[used][inside], track.angle[used][inside]
    x = np.maximum(time - begin, 0) / FALL
    table = fall_row(x)
    fall = np.asarray(np.linalg.lstsq(table, angle, rcond=None)[0], dtype=float)
    columns = np.column_stack([table, -(fall_row(x, 1) @ fall) / FALL])  # d phi / d t0
    inverse = np.linalg.pinv(columns)
    covariance = track.noise**2 * inverse @ inverse.T
    errors = np.sqrt(np.diag(covariance))
    at = nearest(track, begin)
    error = float(np.hypot(errors[0], swayed(track, begin)))
    start = Peak(at, begin, float(errors[-1]), float(fall[0]), error)
    return Release(start, fall, covariance), float((inverse @ (angle - table @ fall))[-1])


def swayed(track: Track, begin: float) -> float:
    """How far a hand moved the leg from its mean over the hold that is followed [rad], by a
    parabola's value at its end; 0 where it moved it no more than the noise may.
    """
    held = slice(*np.searchsorted(track.time, [begin - FALL, begin]))
    time = track.time[held]
    if time.size < FEWEST:
        return 0.0
    x = 1 - 2 * (begin - time) / (begin - time[0])
    moved = legfit(x, track.angle[held], 2)[1:]  # each is 1 at the end
    errors = track.noise * np.sqrt(np.array([3, 5]) / time.size)
    sure = np.hypot(*(moved / errors)) > SURE
    return float(np.hypot(*moved)) if sure else 0.0
