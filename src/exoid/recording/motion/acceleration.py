"""How long a leg accelerates as it did while it surely was free.

Free, its acceleration is a function of angle and speed: phi'' = k0 + k1 cos(phi) + k2 phi + k3 phi'
by least squares over the free part. Where it differs later, a hand is on the leg.
"""

import numpy as np

from exoid.recording.condition import interpolated, local_line
from exoid.recording.motion.limits import BLUR, LATE, PUSH, ROUGH
from exoid.recording.motion.signal import Signal
from exoid.recording.recording import Samples

FEWEST = 8  # samples of the free part, for four numbers


def free_until(signal: Signal, free: slice, limit: int) -> int:
    """One past the last sample that is as free as those of `free`, and not beyond `limit`."""
    angle, speed, acceleration, width = derivatives(signal)
    time = signal.time
    first = int(np.searchsorted(time, time[free.start] + width / 2))
    last = int(np.searchsorted(time, time[free.stop - 1] - width / 2, side="right"))
    if last - first < FEWEST:
        return free.stop
    table = np.stack([np.ones_like(angle), np.cos(angle), angle, speed], axis=1)
    known = np.linalg.lstsq(table[first:last], acceleration[first:last], rcond=None)[0]
    left = acceleration - table @ known
    usual = float(np.sqrt(np.mean(left[first:last] ** 2)))
    greatest = float(np.abs(acceleration[first:last]).max())
    pushed = np.abs(left[last:limit]) > max(ROUGH * usual, PUSH * greatest)
    if not pushed.any():
        return limit
    seen = float(time[last + int(np.argmax(pushed))])
    stop = int(np.searchsorted(time, seen - width / 2 - LATE))
    return max(stop, free.stop)


def derivatives(signal: Signal) -> tuple[Samples, Samples, Samples, float]:
    """Angle, speed, acceleration, and the shortest time [s] over which they are smooth enough."""
    time, filled = signal.time, interpolated(signal.time, signal.angle)
    for width in BLUR:
        count = max(3, round(width / signal.step))
        spread = float(np.std(np.arange(count) * signal.step))
        if signal.velocity is not None:
            angle = local_line(time, filled, width)[0]
            speed, acceleration = local_line(time, signal.velocity, width)
            error = signal.velocity_noise / (spread * np.sqrt(count))
        else:
            half = width / 2
            angle, rough = local_line(time, filled, half)
            speed, acceleration = local_line(time, rough, half)
            error = np.sqrt(5) * signal.angle_noise / (spread**2 * np.sqrt(count))
        if error < PUSH * np.ptp(acceleration) / 2 / ROUGH:
            break
    return angle, speed, acceleration, width
