"""What dry friction does to the turns of a swing: the leg speeds up less after one than before.

It pulls against the motion, so at a turn it changes sides at once. The acceleration falls there by
twice what friction makes of it, the same at every turn. A polynomial through such a kink turns
around too late, and the later the less the leg still swings.
"""

from dataclasses import dataclass, replace

import numpy as np

from exoid.recordings.landmarks.peak import bends_of, peaks
from exoid.recordings.landmarks.track import DEGREE, Peak, Track

AROUND = 0.2  # s to either side of a turn in which its kink is looked for
FEWEST = 4  # samples there on either side
TRIED = 3  # times that a turn and its kink are looked for: within 0.1 ms then
SHARE = 0.1  # of the acceleration at a turn, that a polynomial misses of a spastic leg's swing
MOST = 0.5  # of what a kink is misplaced by, that it misplaces a turn by: more tells no place


@dataclass(frozen=True)
class Kink:
    """By how much the acceleration falls at a turn, its error, and how great it is there
    [rad/s^2].
    """

    fall: float
    error: float
    bend: float = 0.0


def with_friction(track: Track, found: list[Peak], begin: float) -> list[Peak]:
    """The turns, flexion and extension in turn, of a leg that may rub.

    They stay as they were `found` where no kink is seen that exceeds its error.
    """
    each = [kink_at(track, turn, side(number), begin) for number, turn in enumerate(found)]
    told = common([one for one in each if one is not None])
    bends = bends_of(found)
    if told is None or bends is None or told.fall < told.error:
        return found
    return [
        beside(about(track, turn), turn, at_turn(told, bend), begin)
        for turn, bend in zip(found, bends.tolist(), strict=True)
    ]


def at_turn(told: Kink, bend: float) -> Kink:
    """The same at a turn of such a bend, which a leg that friction does not stop there has more of
    than what friction takes and gives.
    """
    most = abs(bend)
    return Kink(float(np.copysign(min(told.fall, most), bend)), min(told.error, most), bend)


def side(number: int) -> float:
    """To which a leg accelerates at a turn, of which the first is a flexion."""
    return 1.0 if number % 2 == 0 else -1.0


def common(kinks: list[Kink]) -> Kink | None:
    """The kink that all turns share, beside what a polynomial misses of a damped swing, which looks
    like one in proportion to the swing: fall = shared + share * bend.
    """
    if len(kinks) < 2:
        return None
    weights = np.array([1 / each.error for each in kinks])
    bends = np.array([each.bend for each in kinks])
    table = np.vstack([np.column_stack([weights, weights * bends]), [0.0, 1 / SHARE]])
    falls = np.append(weights * [each.fall for each in kinks], 0.0)
    inverse = np.linalg.pinv(table)
    found = inverse @ falls
    rough = max(1.0, float(np.linalg.norm(falls - table @ found)) / (len(kinks) - 1) ** 0.5)
    return Kink(float(found[0]), rough * float(np.linalg.norm(inverse[0])))


def kink_at(track: Track, turn: Peak, side: float, begin: float) -> Kink | None:
    """The kink in a polynomial around a turn, at which the leg accelerates to a `side`; None where
    too few samples tell.
    """
    first, last = np.searchsorted(track.time, [max(turn.time - AROUND, begin), turn.time + AROUND])
    x = (track.time[first:last] - turn.time) / AROUND
    if min(np.count_nonzero(x < 0), np.count_nonzero(x > 0)) < FEWEST:
        return None
    bent = -side * np.maximum(x, 0.0) ** 2 / 2
    powers = np.vander(x, DEGREE + 1, increasing=True)
    inverse = np.linalg.pinv(np.column_stack([bent, powers])) / AROUND**2
    fall, _, _, half, *_ = inverse @ track.angle[first:last]
    return Kink(float(fall), track.noise * float(np.linalg.norm(inverse[0])), 2 * abs(float(half)))


def about(track: Track, turn: Peak) -> Track:
    """The second to either side."""
    return track.part(slice(*np.searchsorted(track.time, [turn.time - 1.0, turn.time + 1.0])))


def beside(track: Track, turn: Peak, kink: Kink, begin: float) -> Peak:
    """A turn of the angle without its kink: where that is and where the leg turns are the same
    place, and the errors hold how well it and the kink are known.
    """

    def turned(fall: float, at: float) -> Peak:
        smooth = track.angle + fall / 2 * np.maximum(track.time - at, 0.0) ** 2
        near = int(np.abs(track.time - turn.time).argmin())
        bend = np.array([kink.bend + fall / 2])  # as before the turn
        return peaks(replace(track, angle=smooth), [near], begin, bend)[0]

    found, here, share = turn, turn, 0.0
    apart = max(turn.time_error, track.step)
    for _ in range(TRIED):
        here = turned(kink.fall, found.time)
        later = turned(kink.fall, found.time + apart)
        share = min((later.time - here.time) / apart, MOST)
        found = replace(here, time=found.time + (here.time - found.time) / (1 - share))
    other = turned(kink.fall + kink.error, found.time)
    late = float(np.hypot(here.time_error, other.time - here.time)) / (1 - share)
    unsure = float(np.hypot(here.error, other.value - here.value))
    return replace(found, time_error=late, error=unsure)
