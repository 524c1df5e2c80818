"""How fast the angle moves about which a leg swings, and at which it hangs in the end.

A leg of Eq. 9 hangs still, and swings about one angle but for what gravity's bend makes of the size
of a swing. Where that angle moves, the sensor drifts or the leg sinks: no angle tells which.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from math import hypot

import numpy as np
from numpy.typing import NDArray

from exoid.recordings.landmarks.dying_swing import BENT, swings_of
from exoid.recordings.landmarks.expected_rest import band
from exoid.recordings.landmarks.rest import last_period
from exoid.recordings.landmarks.track import SURE, Peak, Track
from exoid.recordings.measured.samples import Samples

STEADY = np.radians(0.01)  # rad/s, by which either is off beside noise: bends, the steps of counts
LARGEST = np.radians(25.0)  # rad, of a swing about whose middle gravity bends as its square
FEWEST = 3  # middles of swings, which tell a slope beside that bend
DOUBTED = 0.3  # of the errors of turns, by which the band of friction may be wider than it seems
LASTING = 1.0  # s at rest of which a slope is told, and a full swing, at least
BLOCKS, LEAST = 12, 8  # means that tell it, whose scatter is its noise
SWING = 0.1  # of a swing that is left there, in which it may differ from those before


@dataclass(frozen=True)
class Slope:
    """Of an angle [rad/s], with its standard error."""

    value: float
    error: float

    @property
    def sure(self) -> bool:
        return self.clear(SURE)

    def clear(self, errors: float) -> bool:
        """Is it other than 0 by so many standard errors?"""
        return bool(abs(self.value) > errors * self.error)


@dataclass(frozen=True)
class Middle:
    """The angle [rad] about which three turns swing by so much, and when."""

    time: float
    value: float
    error: float
    swing: float


def slope_of_swings(turns: Sequence[Peak]) -> Slope | None:
    """Of the middles of a leg's swings; None where fewer than three are told."""
    each = [middle for end in range(3, len(turns) + 1) if (middle := middle_at(turns[:end]))]
    if len(each) < FEWEST:
        return None
    time, value, error, swing = (
        np.array([getattr(one, name) for one in each])
        for name in ("time", "value", "error", "swing")
    )
    columns = np.stack([np.ones_like(time), time - time.mean(), swing**2], axis=1)
    table = np.vstack([columns / error[:, None], [0.0, 0.0, 1 / BENT]])
    inverse = np.linalg.pinv(table)
    told = np.append(value / error, 0.0)
    found = inverse @ told
    rough = max(1.0, float(np.linalg.norm(told - table @ found)) / (len(each) - 2) ** 0.5)
    return Slope(float(found[1]), hypot(STEADY, rough * float(np.linalg.norm(inverse[1]))))


def middle_at(turns: Sequence[Peak]) -> Middle | None:
    """Of the last three of them a, b and c, which swings that shrink by a factor have at
    (a c - b^2) / (a + c - 2 b); dry friction moves it within its band. None where they do not
    shrink, or are large.
    """
    a, b, c = (each.value for each in turns[-3:])
    share, swing = abs(c - b) / abs(b - a), abs(c - b) / 2
    if share >= 1.0 or swing > LARGEST:
        return None
    bend = a + c - 2 * b
    value = (a * c - b * b) / bend
    parts = ((c - value) / bend, 2 * (b - value) / bend, (a - value) / bend)
    errors = [part * each.error for part, each in zip(parts, turns[-3:], strict=True)]
    error = float(np.linalg.norm([*errors, band(turns, DOUBTED) / 3**0.5]))
    time = (turns[-2].time * share + turns[-1].time) / (1 + share)
    return Middle(time, value, error, swing)


def slope_at_rest(track: Track, turns: list[Peak]) -> Slope | None:
    """Of the later half of what follows the last full swing, beside what is left of it; None where
    too little does.
    """
    period = last_period(turns)
    end, swung = float(track.time[-1]), turns[-1].time + period if turns else np.inf
    begin = max(swung, min(end - max(LASTING, period), (swung + end) / 2))
    resting = slice(int(np.searchsorted(track.time, begin)), None)
    time, angle = track.time[resting], track.angle[resting]
    count = min(BLOCKS, time.size // 3)
    if not period or end - begin < max(LASTING, period) or count < LEAST:
        return None
    columns = [np.ones_like(time), time - time.mean(), *dying(time - begin, turns)]
    table = np.stack([means(each, count) for each in columns], axis=1)
    inverse = np.linalg.pinv(table)
    told = means(angle, count)
    found = inverse @ told
    left = float(np.linalg.norm(told - table @ found)) / (count - len(columns)) ** 0.5
    noise = max(left, track.noise / (time.size / count) ** 0.5)
    swing = SWING * float(np.linalg.norm(found[2:])) / (end - begin)
    error = noise * float(np.linalg.norm(inverse[1]))
    sizes = [part.size for part in np.array_split(time, count)]
    weights = np.repeat(np.asarray(inverse[1], dtype=float) / sizes, sizes)
    rounding = float(track.rounded(weights[None], resting)[0, 0]) ** 0.5
    parts = STEADY, error, swing, rounding, one_count(angle) / (end - begin)
    return Slope(float(found[1]), hypot(*parts))


def dying(since: Samples, turns: list[Peak]) -> list[Samples]:
    """Cosine and sine that shrink as the last of the swings did; none where those do not tell."""
    told = swings_of(turns)
    if told is None:
        return []
    phase = np.exp(told[0]) * since
    return [np.exp(-told[1] * phase) * wave(phase) for wave in (np.cos, np.sin)]


def one_count(angle: Samples) -> float:
    """Half the step [rad] of an encoder that shows few values; 0 of one that shows many."""
    values = np.unique(angle)
    return float(np.diff(values).min()) / 2 if 1 < values.size <= BLOCKS else 0.0


def means(samples: Samples, count: int) -> NDArray[np.float64]:
    return np.array([each.mean() for each in np.array_split(samples, count)])
