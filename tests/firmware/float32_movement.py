"""The firmware's judgement of a movement and of its counts, in NumPy: of many legs at a time."""

from dataclasses import dataclass, fields

import numpy as np
from float32_leg import UNKNOWN, Factored, LegFilter
from float32_sine import ONE, ZERO, F

from exoid.recordings.filter.learning import LEARNING, UNKNOWNS

FADE, MEMORY = F(LEARNING.fade), F(LEARNING.memory)
NARROWER = ONE - MEMORY * MEMORY
MOST, MOST_COUNTED, FARTHEST = 10_000, 20_000, F(16)
LEG_LEVEL = UNKNOWNS.index("level_gravity")


def integers(legs: int, value: int = 0):
    return np.full(legs, value, np.int32)


@dataclass
class Kept:
    """A leg at a moment of its movement."""

    leg: Factored
    squares: np.ndarray
    counted: np.ndarray
    age: np.ndarray
    explained: np.ndarray

    @classmethod
    def nothing(cls, legs: int):
        none = integers(legs)
        return cls(Factored(UNKNOWN, legs), none.astype(F), none, none.copy(), none > 0)

    def put(self, where, other: "Kept"):
        self.leg.put(where, other.leg)
        for each in fields(self)[1:]:
            np.copyto(getattr(self, each.name), getattr(other, each.name), where=where)

    def counts(self, turns):
        gravity = self.leg.mean[LEG_LEVEL] > F(LEARNING.least_gravity)
        return self.explained & (self.age > LEARNING.shortest) & (turns > 0) & gravity


class Surprise:
    """Whiteness and size of innovations."""

    def __init__(self, legs: int):
        self.memory, self.lagged, self.squares = (np.zeros(legs, F) for _ in range(3))
        self.angle, self.rate, self.weight = (np.zeros(legs, F) for _ in range(3))

    def reset(self, where):
        for each in vars(self).values():
            np.copyto(each, ZERO, where=where)

    def see_angle(self, used, weighed, square):
        whitened = weighed * F(LEARNING.angle_variance**0.5)
        np.copyto(self.lagged, FADE * self.lagged + whitened * self.memory, where=used)
        np.copyto(self.memory, MEMORY * self.memory + whitened, where=used)
        np.copyto(self.squares, FADE * FADE * self.squares + ONE, where=used)
        np.copyto(self.angle, FADE * self.angle + square, where=used)
        np.copyto(self.weight, FADE * self.weight + ONE, where=used)

    def see_rate(self, used, _, square):
        np.copyto(self.rate, FADE * self.rate + square, where=used)

    def is_unwhite(self, limit: float):
        return (self.lagged > 0) & (self.lagged * self.lagged * NARROWER > F(limit) * self.squares)

    def is_failing(self):
        loud = F(LEARNING.power) * self.weight
        failing = self.is_unwhite(LEARNING.unwhite) | (self.angle > loud) | (self.rate > loud)
        return (self.weight > F(LEARNING.fewest)) & failing


class Movement:
    """One free movement of each leg."""

    def __init__(self, legs: int):
        self.filter, self.surprise = LegFilter(legs), Surprise(legs)
        self.older, self.newer = Kept.nothing(legs), Kept.nothing(legs)
        self.squares, self.counted = np.zeros(legs, F), integers(legs)
        self.age, self.since, self.astray = (integers(legs) for _ in range(3))
        self.used = self.refused = np.zeros(legs, bool)

    def open(self, where, known: Kept, angle, rate):
        self.filter.open(where, known.leg, angle, rate)
        self.surprise.reset(where)
        many = known.counted > MOST_COUNTED
        counted = np.where(many, known.counted // 2, known.counted)
        squares = np.where(many, F(0.5) * known.squares, known.squares)
        none = np.zeros_like(self.age)
        np.copyto(self.squares, squares, where=where)
        np.copyto(self.counted, counted, where=where)
        for each in (self.age, self.since, self.astray):
            np.copyto(each, 0, where=where)
        for kept in (self.newer, self.older):
            kept.put(where, Kept(known.leg, known.squares, known.counted, none, none == 0))

    def take_angle(self, where, angle, sees_angle):
        """The first half of the work of a look."""
        self.filter.predict(where)
        self.used, self.refused = self.used & ~where, self.refused & ~where
        seen = where & sees_angle
        self.count(seen, self.filter.see_angle(seen, angle), self.surprise.see_angle)

    def take_rate(self, where, rate, sees_rate):
        """The second."""
        seen = where & sees_rate
        self.count(seen, self.filter.see_rate(seen, rate), self.surprise.see_rate)
        astray = np.where(self.refused, self.astray + 1, np.where(self.used, 0, self.astray))
        np.copyto(self.astray, astray, where=where)
        self.age, self.since = self.age + where, self.since + where

    def count(self, seen, correction, look):
        used, weighed, square = correction
        look(used, weighed, square)
        self.used, self.refused = self.used | used, self.refused | (seen & ~used)
        np.copyto(self.squares, self.squares + square, where=used)
        self.counted = self.counted + used

    def is_cut(self):
        angle = self.filter.belief.mean[0]
        return (
            self.surprise.is_failing()
            | (self.astray >= LEARNING.caught)
            | ~(angle * angle < FARTHEST)
        )

    def keep(self, where):
        due = where & (self.since >= LEARNING.kept)
        self.since = np.where(due, 0, self.since)
        self.older.put(due, self.newer)
        now = self.now()
        now.explained = ~self.surprise.is_unwhite(LEARNING.sound)
        self.newer.put(due, now)

    def now(self) -> Kept:
        return Kept(self.filter.leg, self.squares, self.counted, self.age, self.age >= 0)


class Stillness:
    """What a leg does by its counts alone."""

    def __init__(self, legs: int):
        self.low, self.high, self.still, self.peak, self.way, self.turns = (
            integers(legs) for _ in range(6)
        )
        self.blind = integers(legs, MOST)

    def see(self, count, seen, missed):
        gap = np.minimum(missed, MOST)
        self.blind = np.minimum(np.where(seen, gap, self.blind + 1 + gap), MOST)
        low, high = np.minimum(count, self.low), np.maximum(count, self.high)
        anew = (self.still == 0) | (high - low > LEARNING.still)
        settled = seen & ~self.is_lost
        self.low = np.where(settled, np.where(anew, count, low), self.low)
        self.high = np.where(settled, np.where(anew, count, high), self.high)
        longer = np.where(anew, 1, np.minimum(self.still + 1, LEARNING.rest))
        self.still = np.where(self.is_lost, 0, np.where(seen, longer, self.still))
        on = np.where(self.way < 0, self.peak - count, count - self.peak)
        back, far = seen & (on < -LEARNING.departed), seen & (on > LEARNING.departed)
        known = self.way != 0
        self.turns = np.where(known & back, np.minimum(self.turns + 1, MOST), self.turns)
        moved = np.where(known, back | (seen & (on > 0)), back | far)
        way = np.where(known, np.where(back, -self.way, self.way), far.astype(np.int32) - back)
        self.way, self.peak = way, np.where(moved, count, self.peak)

    @property
    def is_lost(self):
        return self.blind > LEARNING.longest_blind

    @property
    def is_at_rest(self):
        return self.still >= LEARNING.rest

    @property
    def place(self):
        return (self.low + self.high) >> 1

    def begin(self, where, count):
        self.turns, self.way = np.where(where, 0, self.turns), np.where(where, 0, self.way)
        self.peak = np.where(where, count, self.peak)
