"""The swings of a leg that was let go: its fall, its turning points, the rest that ends them."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from exoid.recordings.measured.samples import Samples, quantile
from exoid.recordings.motion.signal import Signal, Speed, smoothed
from exoid.recordings.motion.thresholds import (
    BEYOND,
    CHANGE,
    CLEAR,
    GREAT,
    GROWN,
    REST,
    ROCKING,
    SHARE,
    SHORT,
    TRAVEL,
    TURNED,
)
from exoid.recordings.remembered import remembered
from exoid.recordings.signal.condition import reversals, runs

Rest = tuple[int, int]  # its first sample, and one past its last


@dataclass(frozen=True)
class Bounds:
    """Between which samples swings are looked for, and how large they are."""

    begin: int
    free: int  # the first sample that surely is free
    rest: Rest | None
    least: float  # rad, of a swing
    room: float  # rad, by which one may lie outside the one before
    noise: float  # rad, of the smoothed angle


@dataclass(frozen=True, eq=False)
class Swings:
    """The release, where there was one, the turning points after it, and the rest or the end."""

    at: list[int]
    angle: list[float]  # rad, there
    bounds: Bounds

    @cached_property
    def sure(self) -> slice:
        """The samples in which no hand can have ended the last swing."""
        *turns, end = self.at
        free = self.bounds.free
        sure = turns[-1 if len(turns) == 2 else -2] if len(turns) > 1 else (free + end) // 2
        return slice(free, max(sure, free) + 1)


@remembered
def swung(signal: Signal, speed: Speed, begin: int, free: int) -> Swings:
    """The swings from `begin` on, and the rest that ends them, whose angle is the last."""
    noise, rest = smoothed(signal, speed.width)[1], rest_after(signal, speed, begin)
    clear = CLEAR * noise
    bounds = Bounds(begin, free, rest, max(TRAVEL, clear), max(BEYOND, clear), noise)
    return swings_of(speed, signal.samples, bounds)


@remembered  # the same where the noise of the same samples is another
def swings_of(speed: Speed, signal: Signal, bounds: Bounds) -> Swings:
    smooth, begin, rest = smoothed(signal, speed.width)[0], bounds.begin, bounds.rest
    end = signal.time.size - 1 if rest is None else rest[0]
    turns = [begin + at for at in reversals(smooth[begin : end + 1], bounds.least)]
    last = float(smooth[whole(signal, end, speed.width)])
    last = last if rest is None else quantile(smooth[slice(*rest)])
    at, angle = [begin, *turns, end], [*smooth[[begin, *turns]].tolist(), last]
    if begin == 0 and abs(speed.velocity[0]) > speed.still and turns:
        at, angle = at[1:], angle[1:]  # it began within a swing
    return Swings(at, angle, bounds)


def whole(signal: Signal, end: int, width: float) -> int:
    """The last sample up to `end` around which a whole window was recorded: a line goes straight on
    where a leg that turns does not.
    """
    last = np.searchsorted(signal.time, signal.time[-1] - width / 2, side="right") - 1
    return min(int(last), end)


def great_swing(signal: Signal, speed: Speed) -> tuple[int, int]:
    """Where the first swing begins and ends that is a great share of the greatest."""
    smooth, noise = smoothed(signal, speed.width)
    least = max(CLEAR * noise, CHANGE)
    turns = np.array([0, *reversals(smooth, least), smooth.size - 1])
    sizes = np.abs(np.diff(smooth[turns]))
    place = int(np.argmax(sizes > GREAT * sizes.max()))
    return int(turns[place]), int(turns[place + 1])


def before_fall(time: Samples, ahead: Samples, begin: int, end: int) -> float | None:
    """When a speed `ahead` that grows evenly to the greatest of a swing was none [s].

    None where it grew like that from the first sample on: a free leg turns around so.
    """
    top = begin + int(np.argmax(ahead[begin : end + 1]))
    greatest = float(ahead[top])
    low, high = (reached(time[: top + 1], ahead[: top + 1], share * greatest) for share in GROWN)
    if low == high:
        return None
    growth = (GROWN[1] - GROWN[0]) * greatest / (high - low)
    about = low - GROWN[0] * greatest / growth
    return about if abs(ahead[0]) < TURNED * growth * (about - time[0]) else None


def slowed(speed: Speed, within: slice) -> bool:
    """Did it move, and slower again? Of a hand that lets go slowly the leg moves ever faster."""
    moves = np.abs(speed.velocity[within])
    return bool((np.maximum.accumulate(moves) - moves).max(initial=0.0) > speed.still)


def reached(time: Samples, ahead: Samples, least: float) -> float:
    """When a speed last rose beyond the `least` [s]."""
    below = np.flatnonzero(ahead < least)
    last = int(below[-1]) if below.size else 0
    return float(np.interp(least, ahead[last : last + 2], time[last : last + 2]))


def rest_after(signal: Signal, speed: Speed, begin: int) -> Rest | None:
    """The samples of the first lasting rest, which nothing but a hand ends; None without one."""
    time, (angle, noise) = signal.time, smoothed(signal, speed.width)
    band = max(ROCKING[0], ROCKING[1] * speed.still + CLEAR * noise)
    for first, last in runs(np.abs(speed.velocity[begin:]) < speed.still):
        first, last = first + begin, last + begin
        if first == begin or time[last] - time[first] < REST:
            continue
        away = np.abs(angle[first:] - quantile(angle[first : last + 1])) > band
        if not away[: last - first].any():
            return first, first + int(np.argmax(away)) if away.any() else time.size
    return None


def outside(seen: Swings) -> int | None:
    """The first turning point beyond the one before it on the same side."""
    for k in range(2, len(seen.at)):
        former, middle, now = seen.angle[k - 2 : k + 1]
        room = max(seen.bounds.room, SHARE * abs(former - middle))
        if (now - former if former > middle else former - now) > room:
            return k
    return None


def cut_short(ends: list[float]) -> bool:
    """Did the last swing end long before those before it let expect? `ends` as told [rad].

    Free swings shrink by a factor or by equal steps: the next is at least as long as the last less
    what the last had lost. Of a single swing only its two sides are known: a leg goes no farther
    past its rest than it came from.
    """
    if len(ends) < 3:
        return False
    *_, before, last, rest = ends
    swing = abs(last - before)
    if len(ends) == 3:
        return bool(2 * abs(last - rest) - abs(before - rest) > SHORT)
    lost = max(abs(before - ends[-4]) - swing, 0.0)
    return bool(swing - lost - abs(rest - last) > SHORT)
