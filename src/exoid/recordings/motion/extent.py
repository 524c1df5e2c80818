"""A movement in a segment: where it begins and ends, and why there."""

from dataclasses import dataclass
from typing import Literal

import numpy as np


class Motionless(ValueError):
    """A segment in which nothing moves."""


@dataclass(frozen=True)
class End:
    """How a free motion ended."""

    stop: int  # one past its last sample
    ended: Literal["at rest", "caught", "recording stopped"]
    why: str
    hand: int | None = None  # the first sample at which a hand may be on the leg


@dataclass(frozen=True)
class Extent:
    """A movement: samples by number, times in s on the segment's clock.

    From `start` to `free` a hand may still be on the leg: what is seen there tells nothing of it.
    """

    held_until: int | None  # the last sample that surely was held; None if it begins in motion
    release: float  # s, from when on a leg that fell from rest would be as fast
    release_error: float  # s, standard
    start: int  # the sample nearest to the release
    free: int  # the first sample that surely is free of the hand
    stop: int  # one past the last free sample
    hand: int | None  # the first sample after it at which a hand may be on the leg again
    ended: Literal["at rest", "caught", "recording stopped", "returned"]
    why: str
    duration: float = np.nan  # s, of a voluntary cycle
    sure: int = 0  # one past the last sample before which no hand can have ended a swing unseen
    doubted: int = 0  # the first sample that surely is free, if a hand was on a leg said to be free

    @property
    def in_motion(self) -> bool:
        """Was the leg already moving when the recording began?"""
        return self.held_until is None and not self.doubted
