"""How long a leg accelerates as it did while it surely was free.

Free, its acceleration is a function of angle and speed: phi'' = k0 + k1 cos(phi) + k2 phi + k3 phi'
by least squares over the free part, or over those of all drops of this leg. Where it differs later,
a hand is on the leg.
"""

from dataclasses import dataclass
from functools import cached_property
from math import sqrt

import numpy as np
from numpy.typing import NDArray

from exoid.recordings.measured.samples import Samples, quantile
from exoid.recordings.motion.signal import Signal, bends, lines
from exoid.recordings.motion.thresholds import (
    BLUR,
    FEWEST,
    GRIP,
    LATE,
    LEAN,
    PUSH,
    ROUGH,
    SEIZED,
    SURE,
    USUAL,
)
from exoid.recordings.remembered import remembered
from exoid.recordings.signal.local_line import local_line


@dataclass(frozen=True, eq=False)
class Law:
    """What free parts told of a leg."""

    numbers: NDArray[np.floating]  # k0, k1 [rad/s^2], k2 [1/s^2], k3 [1/s]
    scatter: NDArray[np.floating]  # their covariance
    usual: float  # rad/s^2, what it leaves in the free parts
    greatest: float  # rad/s^2, acceleration there

    def clear(self, share: float) -> float:
        """From where on an acceleration is no free leg's; `share` of the greatest at least."""
        return max(ROUGH * self.usual, share * self.greatest)


Part = tuple["Derivatives", slice]  # of a signal, and its samples in which the leg is free


EVERY = np.ones(4)
STRAIGHT = np.array([1.0, 0.0, 1.0, 1.0])  # what small swings tell beyond themselves


def law_of(parts: list[Part], told: NDArray[np.float64] = EVERY) -> Law | None:
    """Of the numbers that are `told`; None where the free parts are too short to tell one."""
    tables, accelerations, alike = [], [], []
    for seen, free in parts:
        inside = within(seen, free)
        if inside.stop - inside.start < FEWEST:
            continue
        tables.append(seen.table[inside] * told)
        accelerations.append(seen.acceleration[inside])
        alike.append(max(seen.width / seen.step, 1.0))  # smoothed samples share their noise
    if not tables:
        return None
    table, acceleration = np.concatenate(tables), np.concatenate(accelerations)
    inverse = np.linalg.pinv(table.T @ table)
    numbers = inverse @ (acceleration @ table)
    share, deviations = USUAL
    usual = quantile(np.abs(acceleration - table @ numbers), share) / deviations
    scatter = max(alike) * usual**2 * inverse
    return Law(numbers, scatter, usual, float(np.abs(acceleration).max()))


@remembered
def own_law(seen: "Derivatives", start: int, stop: int) -> Law | None:
    """What the free part of one signal tells."""
    return law_of([(seen, slice(start, stop))])


def within(seen: "Derivatives", free: slice) -> slice:
    """The samples around which a whole window is free."""
    time, inside = seen.time, seen.time[free]
    if not inside.size:  # it ends as the leg is let go
        return slice(free.start, free.start)
    first = time.searchsorted(inside[0] + seen.width / 2)
    last = time.searchsorted(inside[-1] - seen.width / 2, side="right")
    return slice(int(first), max(int(first), int(last)))


def free_until(seen: "Derivatives", free: slice, limit: int, law: Law | None = None) -> int:
    """One past the last sample that is as free as those of `free`, and not beyond `limit`.

    Without a `law` that part tells its own.
    """
    law = own_law(seen, free.start, free.stop) if law is None else law
    if law is None:
        return free.stop
    at = pushed_at(seen, free, limit, law, law.clear(PUSH))
    if at is None:
        return limit
    since = float(seen.time[at])
    return max(int(seen.time.searchsorted(since - seen.width / 2 - LATE)), free.stop)


def gripped_at(seen: "Derivatives", free: slice, limit: int, law: Law) -> int | None:
    """The first sample after those of `free` at which a hand surely slows the leg down, beyond what
    its own law leaves in this signal too: the `law` may be of a better one.
    """
    own = own_law(seen, free.start, free.stop)
    usual = max(law.usual, 0.0 if own is None else own.usual)
    return pushed_at(seen, free, limit, law, max(SEIZED * usual, GRIP * law.greatest))


def pushed_at(seen: "Derivatives", free: slice, limit: int, law: Law, least: float) -> int | None:
    """The first sample from `free` to `limit` that is `least` rad/s^2 from the law for sure, and
    around which a whole window was recorded.
    """
    last, limit = within(seen, free).stop, min(limit, seen.whole)
    table = seen.table[last:limit]
    unsure = SURE * np.sqrt(np.einsum("ti,ti->t", table @ law.scatter, table))
    pushed = np.abs(seen.acceleration[last:limit] - table @ law.numbers) > least + unsure
    return last + int(np.argmax(pushed)) if pushed.any() else None


def kept_there(seen: "Derivatives", free: slice, rest: slice, law: Law | None = None) -> bool:
    """Is something needed to keep the leg where it rests, if it is as in the samples `free`?"""
    law = own_law(seen, free.start, free.stop) if law is None else law
    if law is None:
        return False
    since = int(seen.time.searchsorted(seen.time[rest.start] + LATE))
    inside = slice(since, min(rest.stop, seen.whole))
    table = seen.table[inside]
    if not table.size:
        return False
    where = table.mean(axis=0)
    needed = abs(float(seen.acceleration[inside].mean() - where @ law.numbers))
    unsure = float(np.sqrt(where @ law.scatter @ where))
    return needed > law.clear(LEAN) + SURE * unsure


@dataclass(frozen=True, eq=False)
class Derivatives:
    """Angle, speed and acceleration at every time, smoothed over `width` s."""

    time: Samples  # s
    step: float  # s
    angle: Samples  # rad
    speed: Samples  # rad/s
    acceleration: Samples  # rad/s^2
    width: float  # s

    @cached_property
    def table(self) -> NDArray[np.float64]:
        """The columns of the law: (sample, number)."""
        return np.stack([np.ones(self.angle.size), np.cos(self.angle), self.angle, self.speed], 1)

    @cached_property
    def whole(self) -> int:
        """One past the last sample around which a whole window was recorded: what is told of those
        after it, a line goes straight on for, where a leg turns.
        """
        return within(self, slice(0, None)).stop

    @cached_property
    def greatest(self) -> float:
        """Half of what the acceleration ranges over [rad/s^2]."""
        return float(np.ptp(self.acceleration)) / 2


@remembered  # who looks for a hand asks several times
def derivatives(signal: Signal) -> Derivatives:
    """Over the shortest window through which a hand would be seen, else the longest."""
    *shorter, longest = BLUR
    for width in shorter:
        found = smoothed_over(signal.samples, width)
        if acceleration_error(signal, width) < PUSH * found.greatest / ROUGH:
            return found
    return smoothed_over(signal.samples, longest)


@remembered  # the same where the noise of the same samples is another
def smoothed_over(signal: Signal, width: float) -> Derivatives:
    if signal.velocity is not None:
        angle = lines(signal, width)[0]
        speed, acceleration = local_line(signal.time, signal.velocity, width)
    else:  # twice: a parabola over the whole width
        angle = lines(signal, width / 2)[0]
        speed, acceleration = bends(signal, width)
    return Derivatives(signal.time, signal.step, angle, speed, acceleration, width)


def acceleration_error(signal: Signal, width: float) -> float:
    """The noise that is left in an acceleration over `width` s [rad/s^2]."""
    spread, root = signal.spread(width), sqrt(signal.count(width))
    if signal.velocity is not None:
        return signal.velocity_noise / (spread * root)
    return sqrt(5) * signal.angle_noise / (spread**2 * root)
