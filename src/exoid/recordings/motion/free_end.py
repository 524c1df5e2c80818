"""Where a free motion ends: at rest, by a hand, or with the recording.

The swings of a free leg lie within each other, and each is about as long as the ones before make
it. A turning point outside, a swing that is cut short, or a movement out of rest is a hand's.
"""

from dataclasses import dataclass
from typing import Literal

import numpy as np

from exoid.recordings.motion.acceleration import Law, free_until, gripped_at, kept_there
from exoid.recordings.motion.signal import Signal, Speed
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
from exoid.recordings.samples import Samples
from exoid.recordings.signal.condition import interpolated, local_line, runs
from exoid.recordings.signal.turning_points import reversals

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
    """The release, where there was one, the turning points after it and the last sample."""

    at: list[int]
    angle: Samples  # rad, there
    error: float  # rad


def free_end(
    signal: Signal, speed: Speed, begin: int, free: int, *, handled: bool, law: Law | None = None
) -> End:
    """Where the motion from `begin` on, free from `free` on, ends; `handled`: by a person.

    A `law` is what other drops of this leg have told of it.
    """
    seen, rest = swung(signal, speed, begin)
    if handled:
        hand = hand_in(signal, seen, free, rest)
        hand = hand or holding(signal, speed, seen, free, rest, None)
        if hand is None and law is not None:
            hand = holding(signal, speed, seen, free, rest, law)
            hand = hand or gripping(signal, seen, free, rest, law)
        if hand is not None:
            return hand
    if rest is None:
        size = signal.time.size
        return End(size, "recording stopped", "the recording stops while the leg moves")
    stop = int(np.searchsorted(signal.time, signal.time[rest[0]] + KEPT, side="right"))
    return End(min(stop, rest[1]), "at rest", "the leg came to rest by itself")


def swung(signal: Signal, speed: Speed, begin: int) -> tuple[Swings, Rest | None]:
    """The swings from `begin` on, and the rest that ends them."""
    smooth, noise = smoothed(signal, speed.width)
    rest = rest_after(signal, speed, smooth, begin, noise)
    seen = swings(smooth, begin, signal.time.size, noise, rest)
    if begin == 0 and abs(speed.velocity[0]) > speed.still and len(seen.at) > 2:
        seen = Swings(seen.at[1:], seen.angle[1:], seen.error)  # it began within a swing
    return seen, rest


def smoothed(signal: Signal, width: float) -> tuple[Samples, float]:
    """The angle over windows of `width` s, and its error."""
    filled = interpolated(signal.time, signal.angle)
    count = max(3, round(width / signal.step))
    return local_line(signal.time, filled, width)[0], signal.angle_noise / np.sqrt(count)


def swings(smooth: Samples, begin: int, stop: int, noise: float, rest: Rest | None) -> Swings:
    """The extremes up to the rest, whose angle is the last; else up to the last sample."""
    end = stop - 1 if rest is None else rest[0]
    turns = [begin + at for at in reversals(smooth[begin : end + 1], max(TRAVEL, CLEAR * noise))]
    last = smooth[end] if rest is None else np.median(smooth[slice(*rest)])
    return Swings([begin, *turns, end], np.array([*smooth[[begin, *turns]], last]), noise)


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
        away = np.abs(angle[first:] - np.median(angle[first : last + 1])) > band
        if not away[: last - first].any():
            return first, first + int(np.argmax(away)) if away.any() else time.size
    return None


def hand_in(signal: Signal, seen: Swings, free: int, rest: Rest | None) -> End | None:
    """The first trace of a hand."""
    place = outside(seen)
    if place is not None:
        sure = seen.at[max(place - 2, 1)]
        return caught(signal, slice(free, sure + 1), seen.at[place])
    if rest is None:
        return None
    if cut_short(seen.angle.tolist()):
        return caught(signal, surely_free(seen, free), seen.at[-1])
    if rest[1] < signal.time.size:
        left = int(np.searchsorted(signal.time, signal.time[rest[1] - 1] - LATE))
        kept = int(np.searchsorted(signal.time, signal.time[rest[0]] + KEPT, side="right"))
        stop = max(min(left, kept), rest[0])
        return End(stop, "at rest", "the leg came to rest, then was moved", left)
    return None


def holding(
    signal: Signal, speed: Speed, seen: Swings, free: int, rest: Rest | None, law: Law | None
) -> End | None:
    """A hand that keeps a leg where it would not stay by itself."""
    size = signal.time.size
    if rest is None:
        still = runs(np.abs(speed.velocity) < speed.still)
        if not still or still[-1][1] < size - 1:
            return None
        rest = (still[-1][0], size)
        if signal.time[-1] - signal.time[rest[0]] < BRIEF:
            return None
    sure = surely_free(seen, free)
    if sure.stop > rest[0] or not kept_there(signal, sure, slice(*rest), law):
        return None
    return caught(signal, sure, rest[0], law)


def gripping(signal: Signal, seen: Swings, free: int, rest: Rest | None, law: Law) -> End | None:
    """A hand that slows the leg down as no free leg of this `law` does."""
    sure = surely_free(seen, free)
    at = gripped_at(signal, sure, signal.time.size if rest is None else rest[0], law)
    return None if at is None else caught(signal, sure, at, law)


def surely_free(seen: Swings, free: int) -> slice:
    """The samples in which no hand can have ended the last swing."""
    *turns, end = seen.at
    sure = turns[-1 if len(turns) == 2 else -2] if len(turns) > 1 else (free + end) // 2
    return slice(free, max(sure, free) + 1)


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
