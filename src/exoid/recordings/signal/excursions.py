"""A few samples in a row that are all off by as much, and then the angle is back where it was.

Markers that a camera takes for each other, a code that an encoder misses: no leg goes by degrees
from one sample to the next, stays there, and comes back as fast. Beside a quintic through the
samples around them these are explained by one offset, down to the noise; a kick, a stop that is hit
or a leg that is caught bends the curve, and is explained by none.
"""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from exoid.recordings.measured.samples import NORMAL, Samples, quantile

BESIDE = 6  # samples on either side that tell where the leg is
COUNTS = range(2, 9)  # samples in a row; one alone is a spike
DEGREE = 5  # of the polynomial: over 0.7 s at 25 Hz a leg departs from it by less than 0.1 deg
SMALLEST = np.radians(2.0)
SURE = 8.0  # standard deviations of such an offset elsewhere in the recording
LEFT = 0.1  # share of the squares that the offset may leave ...
NOISE = 2.0  # ... and times the noise
EVEN = 1.6  # times the usual step: a longer one hides samples
ROUNDS = 30  # each takes the clearest


@dataclass(frozen=True, eq=False)
class Window:
    """What tells an offset of some samples in the middle of others, evenly apart."""

    curves: NDArray[np.float64]  # (sample, curve), orthonormal
    offset: NDArray[np.float64]  # (sample,), whose product with samples is the offset
    squares: float  # of an offset of 1, beside the curves

    @property
    def freedom(self) -> int:
        """Samples, without what explains them."""
        return self.offset.size - DEGREE - 2


@dataclass(frozen=True)
class Excursion:
    """So many samples from `begin` on."""

    begin: int
    count: int
    clear: float  # squares that it explains, over what it leaves of a sample


@lru_cache
def window(count: int) -> Window:
    """Of so many samples."""
    place = np.linspace(-1.0, 1.0, 2 * BESIDE + count)
    curves, _ = np.linalg.qr(np.vander(place, DEGREE + 1))
    inside = np.zeros(place.size)
    inside[BESIDE : BESIDE + count] = 1.0
    own = inside - curves @ (curves.T @ inside)
    return Window(curves, own / (own @ own), float(own @ own))


def find_excursions(time: Samples, angle: Samples, least: float = 0.0) -> NDArray[np.bool_]:
    """Which samples of an angle [rad] belong to one; `least` is what its noise is at least."""
    found = np.zeros(angle.size, dtype=bool)
    bends = np.diff(angle[~np.isnan(angle)], 2)
    if not np.any(np.abs(bends) > SMALLEST / 2):
        return found  # nothing leaps
    for _ in range(ROUNDS):
        known = np.flatnonzero(~(found | np.isnan(angle)))
        each = [best(time[known], angle[known], count, least) for count in COUNTS]
        clearest = max(filter(None, each), key=lambda one: one.clear, default=None)
        if clearest is None:
            break
        found[known[clearest.begin : clearest.begin + clearest.count]] = True
    return found


def best(time: Samples, angle: Samples, count: int, least: float) -> Excursion | None:
    """The clearest of so many samples; None where there is none. `least` is the least noise."""
    told = window(count)
    size, steps = told.offset.size, np.diff(time)
    if angle.size < 2 * size:
        return None
    offset = np.correlate(angle, told.offset, "valid")
    without = np.correlate(angle**2, np.ones(size), "valid")
    for curve in told.curves.T:
        without -= np.correlate(angle, curve, "valid") ** 2
    after = np.maximum(without - offset**2 * told.squares, 0.0)
    noise = max(float(np.sqrt(quantile(after) / told.freedom)), least)
    usual = max(quantile(np.abs(offset)) / NORMAL, noise / np.sqrt(told.squares))
    long = np.correlate(steps > EVEN * quantile(steps), np.ones(size - 1), "valid")
    clear = (np.abs(offset) > max(SMALLEST, SURE * usual)) & (after < LEFT * without)
    clear &= (after < told.freedom * (NOISE * noise) ** 2) & (long == 0)
    if not clear.any():
        return None
    gain = offset**2 * told.squares / (after / told.freedom + noise**2)
    at = int(np.argmax(np.where(clear, gain, 0.0)))
    return Excursion(at + BESIDE, count, float(gain[at]))
