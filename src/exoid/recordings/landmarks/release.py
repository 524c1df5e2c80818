"""How a leg was let go: when, from which angle, and whether nothing held it any more.

Held until t0 by a hand that may sway, it then falls with the speed that it has:

    phi = phi_s + v x + a x^2 + b x^3 + c x^4 + e x^5,   x = t - t0 > 0
    phi = phi_s + v x + f x^2 + g x^3,                   x < 0

A hand that keeps a leg hardly moves it: v, f and g are believed to be about 0.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from math import perm

import numpy as np
from numpy.typing import NDArray

from exoid.recordings.landmarks.local_polynomial import local
from exoid.recordings.landmarks.measure import NotAllowed
from exoid.recordings.landmarks.track import HALF, SURE, Peak, Track, nearest
from exoid.recordings.left_over import orthonormal
from exoid.recordings.measured.samples import Samples
from exoid.recordings.motion.extent import Extent
from exoid.recordings.signal.condition import MOTION_SPEED

FALL = 0.3  # s of the fall that are followed
HOLD = 0.2  # s of the hold: a cubic follows a hand that trembles at 3 Hz over it
LETTING = 0.03  # s by which a hand that takes 0.1 s to let go may do so sooner than it seems
MISSED = 0.07  # of its first acceleration, by what the polynomial leaves out of a quick leg's fall,
# or of one that a hand lets go within 0.1 s
LATE = 0.025  # s by which the first sample may come after the release
NEAR, LATER = 0.03, 0.15  # s around the release that are tried: a hand that gives way by 2 deg/s
# before it lets go looks like the first of a fall
STEP = 0.001  # s between the tried times of release
BLURRED = np.radians(3.0)  # rad/s of error, from which on a first speed is of twice the samples
FALLING, HELD = (0, 1, 2, 3, 4, 5), (2, 3)  # powers of x that are followed after and before t0
BY_HAND = (1, 6, 7)  # of these coefficients, those that a hand makes: speed, and what bends a hold
SWAYS = tuple(np.radians((1.2, 0.6, 0.3)))  # rad, of each: 4 deg/s, as a hand trembles or gives way
FEWEST = 7  # samples of the fall, which 25 Hz give in FALL

Table = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Release:
    """The start of a fall. `fall` holds phi_s, v, a, b, c and e, with x in units of FALL."""

    start: Peak  # s, rad
    fall: Samples
    covariance: Table  # of `fall`

    def derivative(self, order: int, after: Samples) -> tuple[Samples, Samples]:
        """d^order phi / dt^order `after` s into the fall, and their standard errors."""
        rows = fall_row(after / FALL, order) / FALL**order
        error = np.sqrt(np.einsum("ti,ti->t", rows @ self.covariance, rows))
        return rows @ self.fall, error

    def steepest(self) -> tuple[float, float, float]:
        """Where its first part accelerates most towards flexion, of the places that noise hides no
        more than the polynomial does, else of the surest: s after t0, rad/s^2, error.
        """
        tried = np.linspace(0.0, HALF, 11)
        values, errors = self.derivative(2, tried)
        clear = errors <= np.maximum(MISSED * np.abs(values), errors.min())
        at = int(np.argmin(np.where(clear, values, np.inf)))
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
        if error > BLURRED:
            wide = local(track, track.time[[0]], half=2 * HALF).derivative(1)
            begun, error = (float(each[0]) for each in wide)
        speed, unsure = np.degrees([abs(begun), error])
        raise NotAllowed(
            f"begins in motion, at {speed:.0f} ± {unsure:.0f} deg/s: the release was not "
            "recorded. Hold the leg still for a second before you let go"
        )
    return first, first - LATE, NEAR


def fall_row(x: Samples, order: int = 0) -> Samples:
    """A derivative of 1, x, x^2, x^3, x^4 and x^5 (last axis)."""
    return derivatives(x, FALLING, order)


def model_row(x: Samples, order: int = 0) -> Samples:
    """What every coefficient does to the angle, or to its first derivative, at x (last axis)."""
    after, before = np.maximum(x, 0), np.minimum(x, 0)
    parts = (x, FALLING[:2]), (after, FALLING[2:]), (before, HELD)
    return np.concatenate([derivatives(part, powers, order) for part, powers in parts], axis=-1)


def derivatives(x: Samples, powers: Sequence[int], order: int) -> Samples:
    each = [perm(power, order) * x ** max(power - order, 0) for power in powers]
    return np.stack(each, axis=-1)


def believed(track: Track) -> Table:
    """A row for each of SWAYS, which a sample's noise weighs: what a hand does is 0 within them."""
    rows = np.zeros((len(SWAYS), len(FALLING) + len(HELD)))
    rows[range(len(SWAYS)), BY_HAND] = track.noise / np.array(SWAYS)
    return rows


def followed(track: Track, begin: Samples) -> tuple[slice, NDArray[np.bool_]]:
    """The samples from a little before a release at each `begin` to the end of what is followed,
    and which of them belong to each.
    """
    time = track.time
    used = slice(*np.searchsorted(time, [begin.min() - HOLD, begin.max() + FALL]))
    since = time[used] - begin[:, None]
    inside = (since > -HOLD) & (since < FALL)
    if (np.count_nonzero(inside & (since >= 0), axis=1) < FEWEST).any():
        raise NotAllowed(f"cut during the fall: fewer than {FEWEST} samples follow the release")
    return used, inside


def misfits(track: Track, tried: Samples) -> Samples:
    """The sums of squares for each release that is `tried`."""
    used, inside = followed(track, tried)
    x = np.where(inside, (track.time[used] - tried[:, None]) / FALL, 0.0)
    columns = np.where(inside[..., None], model_row(x), 0.0)
    prior = np.broadcast_to(believed(track), (tried.size, *believed(track).shape))
    basis = orthonormal(np.swapaxes(np.concatenate([columns, prior], axis=1), 1, 2).copy())
    angle = np.where(inside, track.angle[used] - track.angle[used].mean(), 0.0)
    along = (basis[..., : angle.shape[1]] @ angle[..., None])[..., 0]
    return (angle**2).sum(axis=1) - (along**2).sum(axis=1)


def refined(track: Track, begin: float) -> tuple[Release, float]:
    """The fall from `begin`, and by how much later [s] a release would fit it best."""
    used = followed(track, np.array([begin]))[0]
    x = (track.time[used] - begin) / FALL
    prior = believed(track)
    table = np.concatenate([model_row(x), prior])
    angle = np.concatenate([track.angle[used], np.zeros(len(prior))])
    found = np.asarray(np.linalg.lstsq(table, angle, rcond=None)[0], dtype=float)
    left = angle - table @ found
    moved = np.concatenate([-(model_row(x, 1) @ found) / FALL, np.zeros(len(prior))])
    inverse = np.linalg.pinv(np.column_stack([table, moved]))  # d phi / d t0 last
    free = max(x.size - table.shape[1], 1)
    rough = max(1.0, float(np.linalg.norm(left)) / track.noise / free**0.5)
    covariance = (rough * track.noise) ** 2 * inverse @ inverse.T
    covariance += track.rounded(np.asarray(inverse[:, : x.size], dtype=float), used)
    errors = np.sqrt(np.diag(covariance))
    tremble = unfollowed(left[: x.size][x < 0], track.noise)
    speed = max(found[1] ** 2 - errors[1] ** 2, 0.0) ** 0.5 / FALL  # beyond what noise does
    error = float(np.linalg.norm([errors[0], tremble, LETTING * speed]))
    start = Peak(nearest(track, begin), begin, float(errors[-1]), float(found[0]), error)
    falling = slice(0, len(FALLING))
    release = Release(start, found[falling], covariance[falling, falling])
    return release, float((inverse @ left)[-1])


def unfollowed(left: Samples, noise: float) -> float:
    """By how much a hand that trembles moves the leg [rad], beside what is followed of the hold and
    what noise does.
    """
    return float(np.sqrt(max(np.mean(left**2) - noise**2, 0.0))) if left.size else 0.0
