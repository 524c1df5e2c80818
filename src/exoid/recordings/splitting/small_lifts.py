"""Lifts by hand that go less far than a movement of its own: known by the angle at which the leg
stays, which is not the one at which it came to rest.
"""

import numpy as np

from exoid.recordings.measured.samples import Samples, quantile
from exoid.recordings.motion.thresholds import CHANGE, HOLD, REST, ROCKING
from exoid.recordings.splitting.piece import Piece

QUICK = 2.5  # s in which a hand lifts a leg so far that it surely moved: what creeps takes longer


def with_small_lifts(time: Samples, smooth: Samples, pieces: list[Piece]) -> list[Piece]:
    """The movements, with a lift behind every drop after which the leg stays higher than it rested,
    until the next movement or the end.
    """
    every = []
    for number, each in enumerate(pieces):
        every.append(each)
        after = pieces[number + 1].start if number + 1 < len(pieces) else time.size
        if each.name == "a drop" and each.kind is not None and each.lifted is None:
            part = slice(each.stop, after)
            found = small_lift(time[part], smooth[part])
            if found is not None:
                first, stop = (each.stop + at for at in found)
                every.append(Piece(first, stop, None, "a lift"))
    return every


def small_lift(time: Samples, angle: Samples) -> tuple[int, int] | None:
    """From when to when a leg is lifted for good that has come to rest: its samples."""
    if not time.size or time[-1] - time[0] < REST + HOLD:
        return None
    rest = quantile(angle[: int(np.searchsorted(time, time[0] + REST)) + 1])
    below = np.flatnonzero(angle - rest < ROCKING[0])
    if not below.size or below[-1] == angle.size - 1:
        return None
    gone = int(below[-1]) + 1
    back = np.flatnonzero(angle[:gone] <= quantile(angle[:gone]))
    first = int(back[-1])
    if time[gone] - time[first] > QUICK:
        return None
    there = np.flatnonzero(angle[gone:] >= quantile(angle[gone:]) - CHANGE)
    return first, gone + int(there[0]) + 1
