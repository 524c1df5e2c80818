"""Where a free motion ends: at rest, by a hand, or with the recording.

The swings of a free leg lie within each other, and each is about as long as the ones before make
it. A turning point outside, a swing that is cut short, or a movement out of rest is a hand's.
"""

from dataclasses import dataclass
from typing import Literal

import numpy as np

from exoid.recordings.motion.acceleration import Law, free_until, gripped_at, kept_there
from exoid.recordings.motion.signal import Signal, Speed, smoothed
from exoid.recordings.motion.thresholds import (
    BEYOND,
    BRIEF,
    CLEAR,
    KEPT,
    LATE,
    REST,
    ROCKING,
    SHARE,
    SHORT,
    TRAVEL,
)
from exoid.recordings.remembered import remembered
from exoid.recordings.samples import Samples, quantile
from exoid.recordings.signal.condition import reversals, runs

Rest = tuple[int, int]  # its first sample, and one past its last
Ending = Literal["at rest", "caught", "recording stopped"]


@dataclass(frozen=True)
class End:
    """How a free motion ended."""

    stop: int  # one past its last sample
    ended: Ending
    why: str
    hand: int | None = None  # the first sample at which a hand may be on the leg


@dataclass(frozen=True, eq=False)
class Swings:
    """The release, where there was one, the turning points after it, and the rest or the last
    sample.
    """

    at: list[int]
    angle: Samples  # rad, there
    error: float  # rad
    free: int  # the first sample that surely is free
    rest: Rest | None

    @property
    def sure(self) -> slice:
        """The samples in which no hand can have ended the last swing."""
        *turns, end = self.at
        sure = turns[-1 if len(turns) == 2 else -2] if len(turns) > 1 else (self.free + end) // 2
        return slice(self.free, max(sure, self.free) + 1)


def free_end(
    signal: Signal, speed: Speed, seen: Swings, *, handled: bool, law: Law | None = None
) -> End:
    """Where a motion with these swings ends; `handled`: by a person.

    A `law` is what other drops of this leg have told of it.
    """
    rest = seen.rest
    if handled:
        hand = hand_in(signal, seen) or holding(signal, speed, seen, None)
        if hand is None and law is not None:
            hand = holding(signal, speed, seen, law) or gripping(signal, seen, law)
        if hand is not None:
            return hand
    if rest is None:
        size = signal.time.size
        return End(size, "recording stopped", "the recording stops while the leg moves")
    stop = int(np.searchsorted(signal.time, signal.time[rest[0]] + KEPT, side="right"))
    return End(min(stop, rest[1]), "at rest", "the leg came to rest by itself")


@remembered
def swung(signal: Signal, speed: Speed, begin: int, free: int) -> Swings:
    """The swings from `begin` on, and the rest that ends them, whose angle is the last."""
    smooth, noise = smoothed(signal, speed.width)
    rest = rest_after(signal, speed, smooth, begin, noise)
    end = signal.time.size - 1 if rest is None else rest[0]
    turns = [begin + at for at in reversals(smooth[begin : end + 1], max(TRAVEL, CLEAR * noise))]
    last = smooth[end] if rest is None else quantile(smooth[slice(*rest)])
    at, angle = [begin, *turns, end], np.array([*smooth[[begin, *turns]], last])
    if begin == 0 and abs(speed.velocity[0]) > speed.still and turns:
        at, angle = at[1:], angle[1:]  # it began within a swing
    return Swings(at, angle, noise, free, rest)


def rest_after(
    signal: Signal, speed: Speed, smooth: Samples, begin: int, noise: float
) -> Rest | None:
    """The samples of the first lasting rest, which nothing but a hand ends; None without one."""
    time, angle = signal.time, smooth
    band = max(ROCKING[0], ROCKING[1] * speed.still + CLEAR * noise)
    for first, last in runs(np.abs(speed.velocity[begin:]) < speed.still):
        first, last = first + begin, last + begin
        if first == begin or time[last] - time[first] < REST:
            continue
        away = np.abs(angle[first:] - quantile(angle[first : last + 1])) > band
        if not away[: last - first].any():
            return first, first + int(np.argmax(away)) if away.any() else time.size
    return None


@remembered
def hand_in(signal: Signal, seen: Swings) -> End | None:
    """The first trace of a hand."""
    place, rest = outside(seen), seen.rest
    if place is not None:
        sure = seen.at[max(place - 2, 1)]
        return caught(signal, slice(seen.free, sure + 1), seen.at[place])
    if rest is None:
        return None
    if cut_short(seen.angle.tolist()):
        return caught(signal, seen.sure, seen.at[-1])
    if rest[1] < signal.time.size:
        left = int(np.searchsorted(signal.time, signal.time[rest[1] - 1] - LATE))
        kept = int(np.searchsorted(signal.time, signal.time[rest[0]] + KEPT, side="right"))
        stop = max(min(left, kept), rest[0])
        return End(stop, "at rest", "the leg came to rest, then was moved", left)
    return None


@remembered
def holding(signal: Signal, speed: Speed, seen: Swings, law: Law | None) -> End | None:
    """A hand that keeps a leg where it would not stay by itself."""
    size, rest = signal.time.size, seen.rest
    if rest is None:
        still = runs(np.abs(speed.velocity) < speed.still)
        if not still or still[-1][1] < size - 1:
            return None
        rest = (still[-1][0], size)
        if signal.time[-1] - signal.time[rest[0]] < BRIEF:
            return None
    if seen.sure.stop > rest[0] or not kept_there(signal, seen.sure, slice(*rest), law):
        return None
    return caught(signal, seen.sure, rest[0], law)


@remembered
def gripping(signal: Signal, seen: Swings, law: Law) -> End | None:
    """A hand that slows the leg down as no free leg of this `law` does."""
    limit = signal.time.size if seen.rest is None else seen.rest[0]
    at = gripped_at(signal, seen.sure, limit, law)
    return None if at is None else caught(signal, seen.sure, at, law)


def caught(signal: Signal, free: slice, limit: int, law: Law | None = None) -> End:
    """Where a hand ended what was free for sure in the samples `free`, before `limit`."""
    stop = free_until(signal, free, limit, law)
    since = float(signal.time[stop - 1])
    return End(stop, "caught", f"stopped or lifted after {since:.2f} s, as by a hand", stop)


def outside(seen: Swings) -> int | None:
    """The first turning point beyond the one before it on the same side."""
    for k in range(2, len(seen.at)):
        former, middle, now = seen.angle[k - 2 : k + 1]
        side = np.sign(former - middle)
        room = max(BEYOND, CLEAR * seen.error, SHARE * abs(former - middle))
        if side * (now - former) > room:
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
