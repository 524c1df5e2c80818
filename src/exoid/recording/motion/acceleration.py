"""How long a leg accelerates as it did while it surely was free.

Free, its acceleration is a function of angle and speed: phi'' = k0 + k1 cos(phi) + k2 phi + k3 phi'
by least squares over the free part. Where it differs later, a hand is on the leg.
"""

from dataclasses import dataclass

import numpy as np

from exoid.recording.condition import interpolated, local_line
from exoid.recording.motion.limits import BLUR, LATE, PUSH, ROUGH
from exoid.recording.motion.signal import Signal
from exoid.recording.recording import Samples

FEWEST = 8  # samples of the free part, for four numbers


def free_until(signal: Signal, free: slice, limit: int) -> int:
    """One past the last sample that is as free as those of `free`, and not beyond `limit`."""
    seen = derivatives(signal)
    time, width, acceleration = signal.time, seen.width, seen.acceleration
    first = int(np.searchsorted(time, time[free.start] + width / 2))
    last = int(np.searchsorted(time, time[free.stop - 1] - width / 2, side="right"))
    if last - first < FEWEST:
        return free.stop
    table = np.stack([np.ones(time.size), np.cos(seen.angle), seen.angle, seen.speed], axis=1)
    known = np.linalg.lstsq(table[first:last], acceleration[first:last], rcond=None)[0]
    left = acceleration - table @ known
    usual = float(np.sqrt(np.mean(left[first:last] ** 2)))
    greatest = float(np.abs(acceleration[first:last]).max())
    pushed = np.abs(left[last:limit]) > max(ROUGH * usual, PUSH * greatest)
    if not pushed.any():
        return limit
    since = float(time[last + int(np.argmax(pushed))])
    stop = int(np.searchsorted(time, since - width / 2 - LATE))
    return max(stop, free.stop)


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
