"""From a track to the landmarks of a drop."""

from collections.abc import Callable

import numpy as np

from exoid.recordings.landmarks.dry_friction import with_friction
from exoid.recordings.landmarks.landmarks import Landmarks
from exoid.recordings.landmarks.local_polynomial import local
from exoid.recordings.landmarks.measure import Found, NotAllowed
from exoid.recordings.landmarks.release import Release, find_release
from exoid.recordings.landmarks.rest import CutBefore, Rest, find_rest
from exoid.recordings.landmarks.swing import turned, turns, with_impacts
from exoid.recordings.landmarks.track import (
    FEWEST,
    HALF,
    SURE,
    Peak,
    Track,
    interrupted,
)
from exoid.recordings.motion.acceleration import Law
from exoid.recordings.motion.extent import Extent, Motionless
from exoid.recordings.motion.find_free import find_free
from exoid.recordings.motion.signal import Signal

SHARE = 0.8  # of its greatest acceleration with which a leg that is let go falls at first: 0.9 and
# more, seldom 0.8, of one that a hand lets go within 0.1 s; 0.5 to 0.7 where it takes 0.3 s


def find_landmarks(
    track: Track, handled: bool = True, law: Law | None = None, seen: Signal | None = None
) -> Landmarks:
    """Everything that can be found on a drop; `handled` by a person, who may catch or lift the leg.

    A `law` is what other drops of this leg have told of it. Where its release was looked for in
    the same samples, `seen`, it is not looked for again.

    **Raises** `NotAllowed` where nothing moves, or what moves does not fall.
    """
    hole = track.interruption
    track, extent = freely(track, seen_alone(track, seen), handled, law)
    hole = hole if hole and hole[0] < track.time[-1] + HALF else None
    released = attempt(lambda: find_release(track, extent))
    free = None if isinstance(released, NotAllowed) else released
    begin = float(track.time[0]) if free is None else free.start.time
    rubbed = with_friction(track, turns(track, begin), begin)
    found, impacts = with_impacts(track, rubbed, begin)
    start = float(track.angle[0]) if free is None else free.start.value
    if found and found[0].value > start:
        raise NotAllowed(f"no drop: it first swings towards extension, up to {found[0].time:.2f} s")
    before, after = around_hole(hole, found)
    ends = found if free is None else [free.start, *found]
    return Landmarks(
        track,
        float(track.time[np.searchsorted(track.time, begin)]),
        before,
        released,
        attempt(lambda: rested(track, extent, ends if after is None else after, hole)),
        None if free is None else held(track, free, before),
        hole and interrupted(*hole),
        tuple(each for each in impacts if hole is None or each.time < hole[0]),
    )


def around_hole(
    hole: tuple[float, float] | None, turns: list[Peak]
) -> tuple[list[Peak], list[Peak] | None]:
    """The turns that can be counted, and those after a hole that hides how many there were; all,
    and None, where there is none.

    **Raises** `NotAllowed` where the hole comes before the first swing is over.
    """
    if hole is None:
        return turns, None
    before = [each for each in turns if each.time + HALF <= hole[0]]
    if not before:
        raise interrupted(*hole)
    return before, [each for each in turns if each.time > hole[1]]


def seen_alone(track: Track, seen: Signal | None) -> Signal:
    """The angle of a track without a gyro: measures are of the angle alone."""
    same = seen is not None and seen.velocity is None and np.array_equal(seen.angle, track.angle)
    return Signal(track.time, track.angle, track.noise, None, np.inf, seen if same else None)


def freely(track: Track, signal: Signal, handled: bool, law: Law | None) -> tuple[Track, Extent]:
    """The track up to where a hand caught or lifted the leg, and its movement."""
    try:
        extent = find_free(signal, handled=handled, law=law)
    except Motionless as fault:
        raise NotAllowed(f"no fall: {fault}") from fault
    first = 0 if handled else first_top(track)
    kept = slice(first, extent.hand and max(extent.hand, FEWEST))
    return track.part(kept), extent


def first_top(track: Track) -> int:
    """Where a rig that is let go below its rest swings back for the first time; else 0."""
    turns = turned(track)
    return turns[0] if turns and track.angle[turns[0]] > track.angle[0] else 0


def rested(
    track: Track, extent: Extent, turns: list[Peak], hole: tuple[float, float] | None
) -> Rest:
    """The rest that a drop ends with, before a hand took the leg if one did; in a hole nobody saw
    that.
    """
    if hole is not None and track.time[-1] < hole[1]:
        raise interrupted(*hole)
    hidden = [at for at, each in enumerate(turns) if track.hole_at(each.time)]
    try:
        return find_rest(track, turns[hidden[-1] + 1 :] if hidden else turns)
    except NotAllowed as why:
        if extent.ended != "caught":
            raise
        raise CutBefore(
            f"not free until it rests: {extent.why}, while it still swung. Leave it alone, and "
            "relaxed, until it hangs still"
        ) from why


def held(track: Track, release: Release, found: list[Peak]) -> NotAllowed | None:
    """Why a fall is not taken for a free one.

    Gravity pulls most at the release, the leg being nearest to the horizontal there, and damping
    and stiffness only grow from then on. So a leg that accelerates far more later than just after
    it began to move was held back by something that then let go. Polynomials over twice the usual
    time tell that of a slow fall, too, whose acceleration noise hides; they end before it turns,
    which a stop or a reflex may do.
    """
    begin, half = release.start.time, 2 * HALF
    end = (found[0].time if found else float(track.time[-1])) - half
    rows = np.flatnonzero((track.time > begin + HALF) & (track.time < end))
    if not rows.size:
        return None
    times = np.array([begin + HALF, *track.time[rows]])
    acceleration, error = local(track, times, begin, half).derivative(2)
    late = 1 + int(np.argmin(acceleration[1:]))
    less = acceleration[0] - SHARE * acceleration[late]
    if less < SURE * np.hypot(error[0], SHARE * error[late]):
        return None
    return NotAllowed(
        f"no free fall: {times[late] - begin:.2f} s after it began to move the leg accelerates by "
        f"{np.degrees(-acceleration[late]):.0f} deg/s^2, just after the beginning by "
        f"{np.degrees(-acceleration[0]):.0f}. A hand was still on it, a muscle held it, the "
        "thigh gave way, or a filter blurred it. Let go at once, without a push, and record the "
        "angle unfiltered"
    )


def attempt(find: Callable[[], Found]) -> Found | NotAllowed:
    """What was found, or why it was not."""
    try:
        return find()
    except NotAllowed as why:
        return why
