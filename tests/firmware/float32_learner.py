"""The firmware's learner of legs once more, in NumPy float32: of many nodes at a time."""

import numpy as np
from float32_learned import LEVEL, Learned, differ, expected_leg, fall, is_within
from float32_look import Look, angle_of
from float32_movement import Kept, Movement, Stillness, integers
from float32_sine import F

from exoid.recordings.filter.learning import LEARNING

HELD, WAITING, LEAVING, MOVING, DONE = range(5)
TRUST_WAITING, LEARNS, GOOD, ENOUGH, UNEXPLAINED, CHANGED, FAULTY = range(7)
NEVER, MOST, TWICE = 1_000_000, 255, 2


class Learner:
    """The nodes."""

    def __init__(self, legs: int):
        self.movement, self.stillness = Movement(legs), Stillness(legs)
        self.known, self.expected = expected_leg(legs), expected_leg(legs)
        self.phase, self.hold, self.away, self.letting_go = (integers(legs) for _ in range(4))
        self.drops, self.failures = integers(legs), integers(legs)
        self.faults, self.gyro, self.same, self.silent = (integers(legs) for _ in range(4))
        self.suspected = integers(legs, NEVER)
        self.first: Look | None = None
        self.seen = Look.nothing(legs)
        self.moving = np.zeros(legs, bool)
        self.anew, self.changed, self.unexplained = (np.zeros(legs, bool) for _ in range(3))

    def take(self, count, gyro, sees_angle, sees_rate, missed):
        """A tick; arrays by leg."""
        self.look(gyro, sees_angle, sees_rate, missed)
        self.stillness.see(count, sees_angle, missed)
        now = Look(count, gyro, sees_angle, sees_rate, missed)
        if self.first is None:
            self.first = now
            self.take_rate()
        else:
            self.seen, self.first = self.first.with_next(now), None
            self.take_angle()

    def take_angle(self):
        """What the second tick of a look begins."""
        was, seen = self.phase.copy(), self.seen
        self.moving = was == MOVING
        if self.moving.any():
            self.movement.take_angle(self.moving, seen.angle, seen.sees_angle)
        self.rest((was == HELD) | (was == DONE))
        self.wait(was == WAITING)
        self.leave(was == LEAVING)

    def take_rate(self):
        """And the tick behind it ends."""
        if self.moving.any():
            self.movement.take_rate(self.moving, self.seen.rate, self.seen.sees_rate)
            self.move(self.moving)
            self.moving = self.moving & False

    def look(self, gyro, sees_angle, sees_rate, missed):
        bad = ~sees_angle | ~sees_rate | (missed > 0)
        more = np.minimum(self.faults + LEARNING.fault_weight, 2 * LEARNING.faults)
        self.faults = np.where(bad, more, np.maximum(self.faults - 1, 0))
        same = np.where(gyro != self.gyro, 0, np.minimum(self.same + 1, LEARNING.frozen))
        self.same = np.where(sees_rate, same, self.same)
        longer = np.minimum(self.silent + 1, LEARNING.longest_silent + 1)
        self.silent = np.where(sees_rate, 0, longer)
        self.gyro = np.where(sees_rate, gyro, self.gyro)

    @property
    def is_doubted(self):
        return self.failures >= LEARNING.failures

    @property
    def begun(self) -> Kept:
        """What a movement begins with."""
        first = Kept.nothing(self.phase.size)
        first.put(True, self.known)
        first.put(self.is_doubted, self.expected)
        return first

    def become(self, where, phase: int):
        np.copyto(self.phase, phase, where=where)

    def settles(self, where):
        still = where & self.stillness.is_at_rest
        self.become(still, WAITING)
        for mine, value in (
            (self.hold, self.stillness.place),
            (self.away, 0),
            (self.suspected, NEVER),
        ):
            np.copyto(mine, value, where=still)
        return where & ~still

    def rest(self, where):
        swings = where & (self.stillness.turns >= self.suspected)
        self.unexplained |= swings
        np.copyto(self.suspected, NEVER, where=swings)
        self.become(self.settles(where) & self.stillness.is_lost, HELD)

    def wait(self, where):
        rest = self.settles(where)
        self.become(rest & self.stillness.is_lost, HELD)
        looks = rest & ~self.stillness.is_lost & self.seen.sees_angle
        off = self.seen.count - self.hold
        np.copyto(
            self.away, np.where(np.abs(off) > LEARNING.departed, self.away + 1, 0), where=looks
        )
        left = looks & (self.away >= TWICE)
        if not left.any():
            return
        fallen = fall(self.begun.leg, angle_of(self.hold))
        falls = np.where(off > 0, fallen > F(LEARNING.pull), fallen < -F(LEARNING.pull))
        self.become(left, HELD)
        self.become(left & falls, LEAVING)
        np.copyto(self.letting_go, LEARNING.letting_go, where=left)

    def leave(self, where):
        seen = self.seen
        self.letting_go = np.where(where, np.maximum(self.letting_go - 1, 0), self.letting_go)
        rest = self.settles(where)
        self.become(rest & self.stillness.is_lost, HELD)
        sound = seen.sees_angle & seen.sees_rate & (seen.missed == 0)
        begins = rest & ~self.stillness.is_lost & (self.letting_go == 0) & sound
        if not begins.any():
            return
        np.copyto(self.anew, self.is_doubted, where=begins)
        self.movement.open(begins, self.begun, seen.angle, seen.rate)
        self.stillness.begin(begins, seen.count)
        self.become(begins, MOVING)

    def move(self, where):
        silent = self.silent > LEARNING.longest_silent
        torn = self.stillness.is_lost | silent | (self.seen.missed > 0)
        caught = self.movement.is_cut()
        cut = caught | torn
        over = where & (cut | self.stillness.is_at_rest)
        self.movement.keep(where & ~over)
        if not over.any():
            return
        end = Kept.nothing(where.size)
        end.put(True, self.movement.now())
        end.put(cut, self.movement.older)
        turns = self.stillness.turns
        counted = over & end.counts(turns)
        fails = over & ~counted & caught & (self.drops > 0) & (self.failures < MOST)
        self.failures = self.failures + fails
        self.learn(counted, end)
        suspected = np.where(caught, turns + LEARNING.swung, NEVER)
        np.copyto(self.suspected, suspected, where=over)
        self.become(over, HELD)
        self.become(counted, DONE)

    def learn(self, where, end: Kept):
        wide, first = end.leg.variance * F(LEARNING.first_fading), self.anew | (self.drops == 0)
        np.copyto(end.leg.variance, wide, where=first)
        other = self.anew & differ(self.known.leg, end.leg)
        better = end.leg.covariance(LEVEL, LEVEL) < self.known.leg.covariance(LEVEL, LEVEL)
        self.known.put(where & (~self.anew | other | better), end)
        drops = np.where(other, 0, self.drops)
        drops = np.where(~self.anew | other, np.minimum(drops + 1, MOST), drops)
        for mine, value in (
            (self.drops, drops),
            (self.changed, other),
            (self.unexplained, False),
            (self.failures, 0),
        ):
            np.copyto(mine, value, where=where)

    @property
    def said(self) -> Kept:
        """The legs as far as they can be told now."""
        found, kept = Kept.nothing(self.phase.size), self.movement.older
        found.put(True, self.known)
        moving = (self.phase == MOVING) & ~self.anew
        found.put(moving & kept.counts(self.stillness.turns), kept)
        return found

    def trust(self, found: Learned):
        begun = (self.drops > 0) | (self.phase == MOVING)
        faulty = (self.faults > LEARNING.faults) | (self.same >= LEARNING.frozen)
        enough = (self.drops > 0) & is_within(found, LEARNING.enough)
        cases = [faulty, self.changed, self.unexplained, enough, is_within(found, LEARNING.good)]
        words = [FAULTY, CHANGED, UNEXPLAINED, ENOUGH, GOOD]
        return np.select([*cases, begun], [*words, LEARNS], TRUST_WAITING)
