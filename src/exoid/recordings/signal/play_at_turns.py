"""Play between a leg and its angle sensor, told by the angle alone where the leg turns back.

There the sensor stands until the play is passed, and is then as far behind as it was ahead. A leg
goes on smoothly meanwhile, but for friction, which bends its way at once where it turns.
"""

import numpy as np
from numpy.typing import NDArray

from exoid.recordings.measured.samples import Samples, usual_step
from exoid.recordings.signal.turns import turns

WIDTHS = np.radians([0.0, 0.2, 0.4, 0.6, 0.8, 1.0, 1.3, 1.6, 2.0, 2.6, 3.2, 4.0])  # rad, of play
BESIDE = 0.2  # s on either side of a turn, over which a leg's way is a polynomial
POWERS = np.array([5, 4, 3, 2, 0])  # of time: it turns where time is 0
LATER = np.arange(-0.1, 0.041, 0.005)  # s, where it turns, behind the middle of what stands lowest
SMOOTH = 0.05  # s, over which an angle's turns are looked for
LEAST = 2.0  # rad/s^2 by which it turns
FEWEST = 14  # samples, of a turn
MANY = 5  # turns that tell a play
SMALL = 1.3  # mean square over the noise, that nothing is looked for in
FALLS = 0.9  # times what is left without play: sensors without any leave all of it

Turn = tuple[Samples, Samples, float]  # times from it [s], angle upwards [rad], its bend [rad/s^2]


def play_at_turns(signals: list[tuple[Samples, Samples]], noise: float) -> float | None:
    """The play [rad] that angles [rad] at times [s] show where they turn; None where none does.
    `noise` [rad] is theirs.
    """
    found = [turn for time, angle in signals for turn in turns_of(time, angle)]
    freedom = sum(time.size - POWERS.size - 3 for time, _, _ in found)
    if len(found) < MANY:
        return None
    without = sum(left_by(turn, 0.0) for turn in found)
    if without < SMALL * freedom * noise**2:
        return None
    left = [sum(left_by(turn, width) for turn in found) for width in WIDTHS[1:]]
    at = int(np.argmin(left))
    return float(WIDTHS[1 + at]) if left[at] < FALLS * without else None


def turns_of(time: Samples, angle: Samples) -> list[Turn]:
    """Those with enough samples on both sides."""
    known = ~np.isnan(angle)
    time, angle = time[known], angle[known]
    if time.size < FEWEST:
        return []
    count = 2 * round(SMOOTH / usual_step(time) / 2) + 1
    even = np.convolve(np.pad(angle, count // 2, mode="edge"), np.ones(count) / count, "valid")
    found = []
    for at in turns(even)[1:-1]:
        near = np.abs(time - time[at]) < BESIDE
        whole = time[0] <= time[at] - BESIDE and time[at] + BESIDE <= time[-1]
        if near.sum() < FEWEST or not whole:
            continue
        since, way = time[near] - time[at], 1.0 if even[at] < even[at - count] else -1.0
        bend = 2 * float(np.polyfit(since, way * angle[near], 2)[0])
        if bend > LEAST:
            found.append((since, way * angle[near], bend))
    return found


def left_by(turn: Turn, width: float) -> float:
    """The squares [rad^2] that a leg leaves whose sensor has so much play [rad], wherever it
    turns.
    """
    since, angle, bend = turn
    passed = (2 * width / bend) ** 0.5  # s
    return min(least_squares(since - later, angle, passed, width) for later in LATER)


def least_squares(since: Samples, angle: Samples, passed: float, width: float) -> float:
    behind: NDArray[np.bool_] = since >= passed
    scaled = np.where((since > 0) & ~behind, 0.0, since) / BESIDE
    friction = np.where(scaled > 0, scaled**2, 0.0)
    ways = np.column_stack([scaled[:, None] ** POWERS, friction])
    shown = angle - np.where(behind, -width / 2, width / 2)
    told = ways @ np.linalg.lstsq(ways, shown, rcond=None)[0]
    return float(np.sum((shown - told) ** 2))
