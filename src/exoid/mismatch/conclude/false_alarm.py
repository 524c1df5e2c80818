"""How often chance would make a cause clear: a bootstrap of this very recording.

What the best explanation leaves, noise and what nobody knows alike, is cut into blocks as long as
it may be correlated, and each is turned over or not by chance (the wild bootstrap of Wu, Annals of
Statistics 14(4), 1986, by blocks). A recording of a leg that lacks nothing would differ from its
simulation like this. What a cause gains on it follows to first order from its derivatives along
that simulation.
"""

from dataclasses import dataclass, replace

import numpy as np

from exoid.mismatch.evidence.measure import LONGEST_LAG
from exoid.mismatch.screen.hypothesis import Hypothesis, Optimum
from exoid.mismatch.screen.many_pinned import with_errors
from exoid.mismatch.screen.measured_motion import MeasuredMotion, rate
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.mismatch.search.found import Found, size
from exoid.mismatch.sensors.compare import inverse

DRAWS = 64
FEWEST = 4  # blocks of a segment
LUCKY = 0.05  # of recordings in which chance may make a cause clear
FAR = 10.0  # times what chance makes in so many, that what is found there must be clearer


@dataclass(frozen=True)
class Chance:
    """What chance makes of a recording in which nothing is missing."""

    rate: float  # chance that a cause is as clear as what was found; clear at all where nothing was
    usual: float  # gain beyond what is clear that one of twenty recordings has
    claimed: float  # that of what was found

    @property
    def doubtful(self) -> bool:
        """May chance make a cause clear, and not by far less than what was found is?"""
        return self.usual > 0 and 0 < self.claimed < FAR * self.usual


def by_chance(found: Found, best: Optimum, seed: int) -> Chance:
    """How clear the clearest of all causes and pairs that were tested is by chance.

    The largest gain of all of them is distributed as Gumbel's law has it, which tells how rare
    what none of the draws reached is.
    """
    measure, tested = found.yardstick, [*found.pinned, *found.glimpsed]
    gained = (found.base.square - best.square) / measure.scale
    claimed = max(gained - measure.least(size(best)), 0.0)
    prepared, (angle, velocity) = found.prepared, np.moveaxis(best.motion, -1, 0)
    draws = turned_over(prepared, best, np.random.default_rng(seed))
    simulated = MeasuredMotion(angle, velocity, rate(velocity, prepared.seen.time))
    each = [(replace(one.candidate, linear=None), simulated) for one in tested]
    tables = with_errors(prepared, each, draws)
    beyond = [
        gains(prepared, one.candidate, table) / measure.scale - measure.least(size(one))
        for one, table in zip(tested, tables, strict=True)
        if np.isfinite(table).all()  # what ran away along this motion is nothing that chance makes
    ]
    if not beyond:
        return Chance(0.0, 0.0, claimed)
    place, width = gumbel(np.max(beyond, axis=0))
    usual = place - width * float(np.log(-np.log(1 - LUCKY)))
    return Chance(above(claimed, place, width), usual, claimed)


def turned_over(
    prepared: PreparedRecording, best: Optimum, random: np.random.Generator
) -> np.ndarray:
    """What is left, its blocks turned over by chance: (draw, segment, time, channel)."""
    seen = prepared.seen
    data = np.stack([seen.angle, seen.angular_velocity], axis=-1)
    known = np.stack([seen.angle_weight, seen.velocity_weight], axis=-1) > 0
    left = np.where(known, data - best.motion, 0.0)
    signs = []
    for time, weighed in zip(seen.time, np.any(known, axis=-1), strict=True):
        since = time - time[0]
        block = min(LONGEST_LAG, float(since[weighed].max()) / FEWEST)
        which = (since / block).astype(int)
        signs.append(random.choice([-1.0, 1.0], (DRAWS, which.max() + 1))[:, which])
    return np.stack(signs, axis=1)[..., None] * left


def gains(prepared: PreparedRecording, one: Hypothesis, table: np.ndarray) -> np.ndarray:
    """What its terms explain of every draw that the leg does not explain."""
    total, leg = one.unknowns.size, prepared.usual.size
    normal = table[:total, :total].copy()
    normal[range(leg), range(leg)] += prepared.usual**2

    def explained(count: int) -> np.ndarray:
        slopes = table[:count, total:]
        return np.sum(slopes * (inverse(normal[:count, :count]) @ slopes), axis=0)

    return explained(total) - explained(leg)


def gumbel(largest: np.ndarray) -> tuple[float, float]:
    """Place and width of the law that the largest of many follow, by their mean and scatter."""
    width = float(np.sqrt(6) / np.pi * np.std(largest))
    return float(np.mean(largest)) - np.euler_gamma * width, width


def above(level: float, place: float, width: float) -> float:
    """The chance of more than a level."""
    return float(-np.expm1(-np.exp((place - level) / width))) if width > 0 else 0.0
