"""Movements that began as free ones and do not count: which, and why."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from jaxtyping import Float, Int

from exoid.online.model.trust import Phase, Trust
from exoid.online.outlook import Outlook
from exoid.watching.estimate.gyro_off import GyroOff

TORN = "samples were lost in it"
CUT = "its segment ended in it"
STRAYED = (
    "it soon moved as no leg does by itself (a hand, a muscle, a sensor, or something missing in "
    "the model)"
)
BACK = np.radians(2.0)  # rad that a leg has come back which is past the bottom of its first fall


@dataclass(frozen=True)
class LeftOut:
    """A movement that does not count."""

    time: float  # s, when that was clear
    begun: float  # s
    why: str
    falling: bool  # did it stray in its first fall, before the leg turned?
    gyro: GyroOff | None = None  # that differs from the encoder, as far as that was seen by then


class Stand(NamedTuple):
    """What is said after a sample."""

    phase: int
    drops: int
    trust: int


class Strays:
    """Follows what an estimator says; a movement that strays may still be explained anew, until
    it has swung on or has come to rest.
    """

    def __init__(self):
        self.stand = Stand(int(Phase.HELD), 0, int(Trust.WAITING))
        self.pending: LeftOut | None = None

    def is_as_before(self, said: Outlook) -> bool:
        return bool((columns_of(said) == np.array(self.stand)[:, None]).all())

    def found(
        self, time: Float[np.ndarray, " time"], angle: Float[np.ndarray, " time"], said: Outlook
    ) -> Iterator[LeftOut]:
        """What is left out by the last samples; `time` and `angle` may begin before those."""
        columns = columns_of(said)
        first = time.size - columns.shape[1]
        before = np.column_stack([self.stand, columns[:, :-1]])
        for at in np.flatnonzero((columns != before).any(axis=0)):
            now, begun = Stand(*columns[:, at].tolist()), float(np.asarray(said.begun)[at])
            seen = slice(int(np.searchsorted(time, begun)), first + int(at) + 1)
            left = LeftOut(float(time[first + at]), begun, STRAYED, is_falling(angle[seen]))
            before, self.stand = self.stand, now
            again = bool(np.asarray(said.late)[at])  # it strayed before, which is told
            yield from self.judged(before, left, again)

    def follow(self, said: Outlook) -> None:
        """The last samples say something else by now."""
        self.stand = Stand(*columns_of(said)[:, -1].tolist())

    def judged(self, before: Stand, left: LeftOut, again: bool) -> Iterator[LeftOut]:
        """Is the movement out by what is said now, and not only `again`?"""
        now = self.stand
        held, counted = now.phase == Phase.HELD, now.drops - before.drops
        if held and counted < 0:
            yield left
        elif held and not counted and before.phase == Phase.MOVING and not again:
            torn = now.trust == Trust.FAULTY
            self.pending = LeftOut(left.time, left.begun, TORN, left.falling) if torn else left
        if self.pending is not None and (is_clear(now) or self.pending.why == TORN):
            left, self.pending = self.pending, None
            yield left


def columns_of(said: Outlook) -> Int[np.ndarray, "3 time"]:
    return np.stack([np.asarray(each) for each in (said.phase, said.drops, said.trust)])


def is_clear(now: Stand) -> bool:
    """Has it swung on, or is the leg at rest?"""
    swings = now.phase == Phase.HELD and now.trust == Trust.UNEXPLAINED
    return swings or now.phase in (Phase.WAITING, Phase.MOVING)


def is_falling(angle: Float[np.ndarray, " time"]) -> bool:
    """Is a leg still on its first way from where it was let go?"""
    seen = angle[np.isfinite(angle)]
    if not seen.size:
        return True
    way = np.abs(seen - seen[0])
    return bool(way.max() - way[-1] < BACK)
