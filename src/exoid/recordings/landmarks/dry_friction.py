"""What dry friction does to the turns of a swing: the leg speeds up less after one than before.

It pulls against the motion, so at a turn it changes sides at once. The acceleration falls there by
twice what friction makes of it, the same at every turn. A polynomial through such a kink turns
around too late, and the later the less the leg still swings.
"""

from dataclasses import dataclass, replace

import numpy as np

from exoid.recordings.landmarks.peak import peaks
from exoid.recordings.landmarks.swing import turned
from exoid.recordings.landmarks.track import DEGREE, Peak, Track

AROUND = 0.2  # s to either side of a turn in which its kink is looked for
FEWEST = 4  # samples there on either side
TRIED = 3  # times that a turn and its kink are looked for: within 0.1 ms then
MOST = 0.5  # of what a kink is misplaced by, that it misplaces a turn by: more tells no place


@dataclass(frozen=True)
class Kink:
    """By how much the acceleration falls at a turn, and its error [rad/s^2]."""

    fall: float
    error: float


def turns(track: Track, begin: float) -> list[Peak]:
    """The turning points after `begin` [s], flexion and extension in turn.

    One counts once the leg has swung back from it by a degree. The first may be an extension,
    where the leg did not fall at first.
    """
    first = int(np.searchsorted(track.time, begin))
    near = [first + at for at in turned(track, first)]
    return with_friction(track, peaks(track, near, begin), begin)


def with_friction(track: Track, found: list[Peak], begin: float) -> list[Peak]:
    """The turns, flexion and extension in turn, of a leg that may rub.

    They stay as they were `found` where no kink is seen that exceeds its error.
    """
    each = [kink_at(track, turn, side(number), begin) for number, turn in enumerate(found)]
    told = mean_of([one for one in each if one is not None])
    if told is None or told.fall < told.error:
        return found
    return [
        beside(about(track, turn), turn, Kink(side(number) * told.fall, told.error), begin)
        for number, turn in enumerate(found)
    ]


def side(number: int) -> float:
    """To which a leg accelerates at a turn, of which the first is a flexion."""
    return 1.0 if number % 2 == 0 else -1.0


def mean_of(kinks: list[Kink]) -> Kink | None:
    if not kinks:
        return None
    weights = np.array([each.error**-2 for each in kinks])
    falls = np.array([each.fall for each in kinks])
    return Kink(float(weights @ falls / weights.sum()), float(weights.sum() ** -0.5))


def kink_at(track: Track, turn: Peak, side: float, begin: float) -> Kink | None:
    """The kink in a polynomial around a turn, at which the leg accelerates to a `side`; None where
    too few samples tell.
    """
    first, last = np.searchsorted(track.time, [max(turn.time - AROUND, begin), turn.time + AROUND])
    x = (track.time[first:last] - turn.time) / AROUND
    if min(np.count_nonzero(x < 0), np.count_nonzero(x > 0)) < FEWEST:
        return None
    bent = -side * np.maximum(x, 0.0) ** 2 / 2
    row = np.linalg.pinv(np.column_stack([bent, np.vander(x, DEGREE + 1)]))[0] / AROUND**2
    return Kink(float(row @ track.angle[first:last]), track.noise * float(np.linalg.norm(row)))


def about(track: Track, turn: Peak) -> Track:
    """The second to either side."""
    part = slice(*np.searchsorted(track.time, [turn.time - 1.0, turn.time + 1.0]))
    return replace(track, sample=track.sample[part], time=track.time[part], angle=track.angle[part])


def beside(track: Track, turn: Peak, kink: Kink, begin: float) -> Peak:
    """A turn of the angle without its kink: where that is and where the leg turns are the same
    place, and the errors hold how well it and the kink are known.
    """

    def turned(fall: float, at: float) -> Peak:
        smooth = track.angle + fall / 2 * np.maximum(track.time - at, 0.0) ** 2
        near = int(np.abs(track.time - turn.time).argmin())
        return peaks(replace(track, angle=smooth), [near], begin)[0]

    def nearer(found: Peak) -> tuple[Peak, Peak, float]:
        here, later = (turned(kink.fall, found.time + by) for by in (0.0, apart))
        share = min((later.time - here.time) / apart, MOST)
        at = found.time + (here.time - found.time) / (1 - share)
        return replace(here, time=at), here, share

    apart = max(turn.time_error, track.step)
    found, here, share = nearer(turn)
    for _ in range(TRIED - 1):
        found, here, share = nearer(found)
    other = turned(kink.fall + kink.error, found.time)
    late = float(np.hypot(here.time_error, other.time - here.time)) / (1 - share)
    unsure = float(np.hypot(here.error, other.value - here.value))
    return replace(found, time_error=late, error=unsure)
