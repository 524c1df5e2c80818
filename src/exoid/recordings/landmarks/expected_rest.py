"""Where a leg would have come to rest that was caught before, or whose record was cut."""

from collections.abc import Sequence

import numpy as np

from exoid.recordings.landmarks.measure import NotAllowed
from exoid.recordings.landmarks.track import SURE, Peak

FEWEST = 3  # turns
LAST = 3  # middles of swings, by which the next may move


def expected_rest(turns: Sequence[Peak]) -> Peak:
    """The angle to which swings shrink, by the last three turns a, b and c of a fall.

    Swings of viscous damping shrink by a factor q = |c - b| / |b - a|, to c - (c - b) q / (1 + q);
    those of dry friction by equal steps towards the same angle. Friction then holds the leg
    anywhere within a band about it, which the error has as a uniform distribution.

    **Raises** `NotAllowed` where there are fewer turns, or swings do not shrink.
    """
    if len(turns) < FEWEST:
        raise NotAllowed(
            f"cut before rest, and of {FEWEST} turns there are {len(turns)}: what swings shrink to "
            "is not told. Let it swing, and record, until it hangs still"
        )
    first, middle, last = turns[-FEWEST:]
    before, after = middle.value - first.value, last.value - middle.value
    share = abs(after) / abs(before)
    if share >= 1.0:
        raise NotAllowed("cut before rest, and its swings do not shrink: was it moved by a hand?")
    errors = [each.error for each in (first, middle, last)]
    value = last.value - after * share / (1.0 + share)
    error = float(np.linalg.norm([*errors, band(turns) / 3**0.5]))
    return Peak(last.sample, last.time, last.time_error, value, error)


def middles(ends: Sequence[Peak]) -> list[float]:
    """The angles to which swings shrink, by every three ends of them in turn [rad]: one, of a leg
    whose torque is as its angle; of a muscle that tightens or lets go they move.
    """
    angles = np.array([each.value for each in ends])
    before, after = np.diff(angles)[:-1], np.diff(angles)[1:]
    share = np.abs(after / before)
    return (angles[2:] - after * share / (1.0 + share)).tolist()


def band(turns: Sequence[Peak], sure: float = SURE) -> float:
    """Half of that within which friction may hold the leg [rad], `sure` by so many standard errors.

    With viscous damping beside it, each swing is s' = q s - 2 f (1 + q), f the half band: three
    swings tell both. Two tell that f is at most a quarter of what they differ by, as all of that
    would be friction.
    """
    swings = np.abs(np.diff([each.value for each in turns[-FEWEST - 1 :]]))
    most = float(swings[-2] - swings[-1]) / 4
    steps = -np.diff(swings)
    if len(steps) < 2 or not steps.min() > 0:
        return most
    share = min(float(steps[1] / steps[0]), 1.0)
    told = max(float(share * swings[0] - swings[1]), 0.0) / (2 * (1 + share))
    noise = float(np.linalg.norm([each.error for each in turns[-FEWEST - 1 :]]))
    return min(most, told + sure * noise * float(swings[0] / steps[0]))
