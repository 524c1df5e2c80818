"""Where a free motion ends: at rest, by a hand, or with the recording.

The swings of a free leg lie within each other, and each is about as long as the ones before make
it. A turning point outside, a swing that is cut short, or a movement out of rest is a hand's.
"""

from dataclasses import replace

import numpy as np

from exoid.recordings.measured.samples import Samples, quantile, usual_step
from exoid.recordings.motion.acceleration import (
    Derivatives,
    Law,
    derivatives,
    free_until,
    gripped_at,
    kept_there,
)
from exoid.recordings.motion.brought_to_rest import Course, brought_to_rest
from exoid.recordings.motion.extent import End
from exoid.recordings.motion.signal import Signal, Speed
from exoid.recordings.motion.swings import Swings, cut_short, outside
from exoid.recordings.motion.thresholds import BRIEF, KEPT, LATE, PUSH, UNSEEN
from exoid.recordings.remembered import remembered
from exoid.recordings.signal.condition import runs

AS_BEFORE, UNEVEN = 2, 0.1  # swings, and the share by which these differ, of a leg that nobody has


def free_end(
    signal: Signal, speed: Speed, seen: Swings, *, handled: bool, law: Law | None = None
) -> End:
    """Where a motion with these swings ends; `handled`: by a person.

    A `law` is what other drops of this leg have told of it.
    """
    rest = seen.bounds.rest
    if handled:
        moves = derivatives(signal)
        hand = hand_in(seen, moves) or holding(seen, moves, speed, None)
        if hand is None and law is not None:
            hand = holding(seen, moves, speed, law) or gripping(seen, moves, law)
        if hand is not None:
            return hand
    if rest is None:
        size = signal.time.size
        return End(size, "recording stopped", "the recording stops while the leg moves")
    stop = int(np.searchsorted(signal.time, signal.time[rest[0]] + KEPT, side="right"))
    return End(min(stop, rest[1]), "at rest", "the leg came to rest by itself")


@remembered
def hand_in(seen: Swings, moves: Derivatives) -> End | None:
    """The first trace of a hand."""
    place, rest, time = outside(seen), seen.bounds.rest, moves.time
    if place is not None:
        sure = slice(seen.bounds.free, seen.at[max(place - 2, 1)] + 1)
        end = caught(moves, sure, seen.at[place])
        swing = abs(seen.angle[place - 1] - seen.angle[place - 2])
        return before_lift(moves, sure, end) if swing < unseen(moves, sure) else end
    course = course_of(seen, time)
    early = brought_to_rest(course)
    if early is not None:
        sure = slice(seen.bounds.free, seen.at[early - 1] + 1)
        return with_clock(caught(moves, sure, seen.at[early]), course, early)
    if rest is None:
        return None
    if cut_short(seen.angle):
        return caught(moves, seen.sure, seen.at[-1])
    if rest[1] < time.size:
        left = int(time.searchsorted(time[left_rest(moves.angle, *rest)] - LATE))
        kept = int(time.searchsorted(time[rest[0]] + KEPT, side="right"))
        stop = max(min(left, kept), rest[0])
        return End(stop, "at rest", "the leg came to rest, then was moved", max(left, rest[0]))
    return None


def with_clock(end: End, course: Course, early: int) -> End:
    """The same end of a leg that swings on from that swing as before, but in another time, as none
    does that a hand has taken: then its times may be wrong.
    """
    before, after = course.lasting[1:early], course.lasting[early:-1]
    if min(before.size, after.size) < AS_BEFORE or np.ptp(after) > UNEVEN * after.max():
        return end
    shrunk = [np.diff(np.log(part)).mean() for part in (course.size[:early], course.size[early:-1])]
    if abs(shrunk[1] - shrunk[0]) > UNEVEN:
        return end
    share = float(np.median(after) / np.median(before))
    said = f"its swings take {share:.2g} times as long as before, and shrink as before"
    return replace(end, why=f"{end.why}, or its times are wrong from there on ({said})")


def course_of(seen: Swings, time: Samples) -> Course:
    """From turning point to turning point."""
    holes = np.flatnonzero(np.diff(time) > UNSEEN)
    at, bounds = np.array(seen.at), seen.bounds
    inside = (holes + 1 >= at[:-1, None]) & (holes <= at[1:, None])
    whole = np.asarray(~inside.any(axis=1))
    rested, step = bounds.rest is not None, usual_step(time)
    return Course(np.array(seen.angle), time[at], whole, rested, bounds.least, bounds.noise, step)


def left_rest(angle: Samples, first: int, stop: int) -> int:
    """The last sample of a rest at which the leg was where it rested: a hand lifts it softly, long
    before it has gone farther than a leg at rest does.
    """
    rested = quantile(angle[first:stop])
    away = angle[first:stop] - rested
    back = np.flatnonzero(away * (angle[stop] - rested) <= 0)
    return first + int(back[-1]) if back.size else first


@remembered
def holding(seen: Swings, moves: Derivatives, speed: Speed, law: Law | None) -> End | None:
    """A hand that keeps a leg where it would not stay by itself."""
    time, rest = moves.time, seen.bounds.rest
    if rest is None:
        still = runs(np.abs(speed.velocity) < speed.still)
        if not still or still[-1][1] < time.size - 1:
            return None
        rest = (still[-1][0], time.size)
        if time[-1] - time[rest[0]] < BRIEF:
            return None
    if seen.sure.stop > rest[0] or not kept_there(moves, seen.sure, slice(*rest), law):
        return None
    return caught(moves, seen.sure, rest[0], law)


@remembered
def gripping(seen: Swings, moves: Derivatives, law: Law) -> End | None:
    """A hand that slows the leg down as no free leg of this `law` does."""
    limit = moves.time.size if seen.bounds.rest is None else seen.bounds.rest[0]
    at = gripped_at(moves, seen.sure, limit, law)
    return None if at is None else caught(moves, seen.sure, at, law)


def before_lift(moves: Derivatives, free: slice, end: End) -> End:
    """The end of what surely was free in the samples `free`, before the movement in which a hand
    was seen, where the leg had not gone far in it.
    """
    ahead = moves.speed * np.sign(moves.speed[min(end.stop, moves.speed.size - 1)])
    back = np.flatnonzero(ahead[free.stop : end.stop] <= 0)
    turn = free.stop + int(back[-1]) if back.size else free.stop
    if abs(moves.angle[end.stop - 1] - moves.angle[turn]) > unseen(moves, free):
        return end
    stop = max(int(moves.time.searchsorted(moves.time[turn] - LATE)), free.stop)
    return caught_at(moves, min(stop, end.stop))


def unseen(moves: Derivatives, free: slice) -> float:
    """How far a hand may move a leg before it is seen [rad]: it then pulls with a share of the
    greatest acceleration, as far from rest as that share of the way to where the leg was let go.
    """
    return PUSH * float(np.ptp(moves.angle[free])) / 2


def caught(moves: Derivatives, free: slice, limit: int, law: Law | None = None) -> End:
    """Where a hand ended what was free for sure in the samples `free`, before `limit`."""
    return caught_at(moves, free_until(moves, free, limit, law))


def caught_at(moves: Derivatives, stop: int) -> End:
    since = float(moves.time[stop - 1])
    by = "as by a hand, or by a muscle that tightens or lets go"
    return End(stop, "caught", f"stopped or moved after {since:.2f} s, {by}", stop)
