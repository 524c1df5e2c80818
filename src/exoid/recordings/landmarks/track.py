"""The angle of a drop where it was measured, and the places on it."""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from exoid.recordings.landmarks.measure import Mark, NotAllowed
from exoid.recordings.measured.samples import Samples, block_means, block_size, quantile, usual_step
from exoid.recordings.measured.segment import Segment
from exoid.recordings.motion.thresholds import BLOCK
from exoid.recordings.signal.rounding import least_step, shared

HALF = 0.1  # s to either side that a polynomial follows, a tenth of a leg's swing
DEGREE = 4  # the middle of a swing is then followed to 1 in 2000, its acceleration included
SURE = 3.0  # standard errors
FEWEST = DEGREE + 2  # samples of a polynomial
HOLE = 0.3  # s without an angle that are bridged: a leg turns around once in them at most
LONGEST = 1.0  # s without one, before and after which a drop is read
SLOWEST = 0.041  # s between samples, of PAL cameras: of a slower recording, fewer than six samples
# would tell a turn


@dataclass(frozen=True)
class Peak:
    """An extreme, or another place on the curve, with its errors."""

    sample: int  # of the segment, the nearest
    time: float  # s
    time_error: float  # s
    value: float  # rad, rad/s or rad/s^2
    error: float

    @property
    def mark(self) -> Mark:
        return Mark(self.sample, self.time, self.value)


@dataclass(frozen=True, eq=False)
class Track:
    """The angle of a drop where it was measured."""

    sample: NDArray[np.int_]  # in the segment
    time: Samples  # s, on the segment's clock
    angle: Samples  # rad
    noise: float  # rad, white, of one sample
    shown: Samples  # rad, before anything was taken off it: samples of one code are alike
    code: float  # rad, the least step between two that were shown

    def part(self, rows: slice) -> "Track":
        """Some of its samples."""
        each = {name: getattr(self, name)[rows] for name in ("sample", "time", "angle", "shown")}
        return replace(self, **each)

    def rounded(self, weights: NDArray[np.floating], rows: slice) -> NDArray[np.float64]:
        """The covariance of sums over some samples with these weights (sum, sample), by the
        rounding that samples have in common, beside their white noise.
        """
        each = self.code * shared(weights, self.shown[rows])
        return each @ each.T

    def smoothed_noise(self, width: float) -> float:
        """What of it is left [rad] in straight lines over `width` s."""
        return self.noise / np.sqrt(max(width / self.step, 3.0))

    @cached_property
    def step(self) -> float:
        return usual_step(self.time)

    def hole_at(self, time: float, beside: float = 0.0) -> tuple[float, float] | None:
        """The hole that no polynomial bridges in which a time lies, or so near to which [s]."""
        inside = (each for each in self.holes if each[0] - beside <= time <= each[1] + beside)
        return next(inside, None)

    def check_seen(self, time: float, beside: float = 0.0) -> None:
        """Refuse a place in a hole."""
        hole = self.hole_at(time, beside)
        if hole is not None:
            raise NotAllowed(f"not seen: {unseen(*hole)}")

    @cached_property
    def holes(self) -> list[tuple[float, float]]:
        """From when to when [s] no angle was measured for longer than a polynomial follows."""
        at = np.flatnonzero(np.diff(self.time) > HALF)
        return list(zip(self.time[at].tolist(), self.time[at + 1].tolist(), strict=True))

    @cached_property
    def interruption(self) -> tuple[float, float] | None:
        """The first hole in which a leg may turn around twice [s]."""
        return next((each for each in self.holes if each[1] - each[0] > HOLE), None)

    @cached_property
    def uneven(self) -> float:
        """By how much a step is other than the usual one, at most [s]."""
        return float(np.abs(np.diff(self.time) - self.step).max())


def track_of(segment: Segment, noise: float) -> Track:
    """The encoder's angle, or the filtered one where there is no other; means over a few samples
    where they are many.

    **Raises** `NotAllowed` where it is sampled too slowly, or interrupted.
    """
    sample = np.flatnonzero(~np.isnan(segment.best_angle))
    time = segment.time[sample]
    if time.size < FEWEST:
        raise NotAllowed(f"too short: it holds {time.size} samples of the angle")
    steps = np.diff(time)
    step = quantile(steps)
    if step > SLOWEST:
        raise NotAllowed(f"sampled too slowly: at {1 / step:.3g} Hz, 25 Hz are the least")
    if steps.max() > LONGEST:
        at = int(np.argmax(steps))
        raise interrupted(time[at], time[at + 1])
    count = block_size(step, BLOCK)
    middle = sample[count // 2 :: count][: sample.size // count]
    angle = block_means(segment.best_angle[sample], count)
    code = least_step(segment.best_angle[sample])
    return Track(middle, block_means(time, count), angle, noise / np.sqrt(count), angle, code)


def interrupted(begin: float, end: float) -> NotAllowed:
    """Why nothing is read that needs every turn of the leg."""
    return NotAllowed(
        f"interrupted: {unseen(begin, end)}, and a leg may turn around twice in more than "
        f"{HOLE:g} s. Let it drop again, and see that the angle is seen throughout"
    )


def unseen(begin: float, end: float) -> str:
    return f"no angle was measured from {begin:.2f} to {end:.2f} s"


def nearest(track: Track, time: float) -> int:
    """The sample of the segment that is nearest to a time."""
    after = min(max(int(np.searchsorted(track.time, time)), 1), track.time.size - 1)
    before, later = time - track.time[after - 1], track.time[after] - time
    return int(track.sample[after - 1 if before <= later else after])
