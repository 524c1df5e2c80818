"""How long a leg accelerates as it did while it surely was free.

Free, its acceleration is a function of angle and speed: phi'' = k0 + k1 cos(phi) + k2 phi + k3 phi'
by least squares over the free part. Where it differs later, a hand is on the leg.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from exoid.recording.condition import interpolated, local_line
from exoid.recording.motion.limits import BLUR, LATE, LEAN, PUSH, ROUGH, SURE
from exoid.recording.motion.signal import Signal
from exoid.recording.recording import Samples

FEWEST = 8  # samples of the free part, for four numbers


def free_until(signal: Signal, free: slice, limit: int) -> int:
    """One past the last sample that is as free as those of `free`, and not beyond `limit`."""
    left = unexplained(signal, free)
    if left is None:
        return free.stop
    pushed = np.abs(left.acceleration[left.last : limit]) > left.clear(PUSH)
    if not pushed.any():
        return limit
    since = float(signal.time[left.last + int(np.argmax(pushed))])
    stop = int(np.searchsorted(signal.time, since - left.width / 2 - LATE))
    return max(stop, free.stop)


def kept_there(signal: Signal, free: slice, rest: slice) -> bool:
    """Is something needed to keep the leg where it rests, if it is as in the samples `free`?"""
    left = unexplained(signal, free)
    if left is None:
        return False
    inside = slice(int(np.searchsorted(signal.time, signal.time[rest.start] + LATE)), rest.stop)
    needed = left.acceleration[inside]
    if not needed.size:
        return False
    where = left.table[inside].mean(axis=0)
    unsure = float(np.sqrt(where @ left.scatter @ where))
    return bool(abs(float(np.mean(needed))) > left.clear(LEAN) + SURE * unsure)


@dataclass(frozen=True, eq=False)
class Unexplained:
    """What a law of acceleration leaves that was told by a free part."""

    acceleration: Samples  # rad/s^2
    table: NDArray[np.float64]  # (sample, number of the law)
    scatter: NDArray[np.floating]  # covariance of its numbers
    usual: float  # rad/s^2, in the free part
    greatest: float  # rad/s^2, acceleration there
    last: int  # one past the free samples that told it
    width: float  # s, of the smoothing

    def clear(self, share: float) -> float:
        """From where on it is no free leg's; `share` of the greatest at least."""
        return max(ROUGH * self.usual, share * self.greatest)


def unexplained(signal: Signal, free: slice) -> Unexplained | None:
    """None where the free part is too short to tell a law."""
    seen, time = derivatives(signal), signal.time
    first = int(np.searchsorted(time, time[free.start] + seen.width / 2))
    last = int(np.searchsorted(time, time[free.stop - 1] - seen.width / 2, side="right"))
    if last - first < FEWEST:
        return None
    table = np.stack([np.ones(time.size), np.cos(seen.angle), seen.angle, seen.speed], axis=1)
    known = np.linalg.lstsq(table[first:last], seen.acceleration[first:last], rcond=None)[0]
    left = seen.acceleration - table @ known
    usual = float(np.sqrt(np.mean(left[first:last] ** 2)))
    greatest = float(np.abs(seen.acceleration[first:last]).max())
    alike = max(seen.width / signal.step, 1.0)  # smoothed samples share their noise
    scatter = alike * usual**2 * np.linalg.pinv(table[first:last].T @ table[first:last])
    return Unexplained(left, table, scatter, usual, greatest, last, seen.width)


@dataclass(frozen=True, eq=False)
class Derivatives:
    """Angle, speed and acceleration, smoothed over `width` s, and the acceleration's error."""

    angle: Samples  # rad
    speed: Samples  # rad/s
    acceleration: Samples  # rad/s^2
    error: float  # rad/s^2
    width: float  # s

    @property
    def clear(self) -> bool:
        """Would a hand be seen through the noise?"""
        return bool(self.error < PUSH * np.ptp(self.acceleration) / 2 / ROUGH)


def derivatives(signal: Signal) -> Derivatives:
    """Over the shortest window through which a hand would be seen, else the longest."""
    found = [smoothed_over(signal, width) for width in BLUR]
    return next((each for each in found if each.clear), found[-1])


def smoothed_over(signal: Signal, width: float) -> Derivatives:
    time, filled = signal.time, interpolated(signal.time, signal.angle)
    count = max(3, round(width / signal.step))
    spread = float(np.std(np.arange(count) * signal.step))
    if signal.velocity is not None:
        speed, acceleration = local_line(time, signal.velocity, width)
        error = signal.velocity_noise / (spread * np.sqrt(count))
        return Derivatives(local_line(time, filled, width)[0], speed, acceleration, error, width)
    angle, rough = local_line(time, filled, width / 2)  # twice: a parabola over the whole width
    speed, acceleration = local_line(time, rough, width / 2)
    error = float(np.sqrt(5) * signal.angle_noise / (spread**2 * np.sqrt(count)))
    return Derivatives(angle, speed, acceleration, error, width)
