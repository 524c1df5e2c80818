"""What an answer is made of: numbers with their intervals, or why there are none."""

from dataclasses import dataclass


class NotTold(Exception):
    """The tables do not tell it; the message says why, as a sentence."""


@dataclass(frozen=True)
class Interval:
    """A value with its 95 % interval; the ends are NaN where they could not be found."""

    value: float
    low: float
    high: float


@dataclass(frozen=True)
class Untold:
    """A question that the tables do not answer."""

    why: str
