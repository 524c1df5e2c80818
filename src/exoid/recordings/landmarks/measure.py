"""One number read off a drop, with its error and its place on the curve, or why it is not read."""

from dataclasses import dataclass
from typing import TypeVar

Found = TypeVar("Found")


@dataclass(frozen=True)
class Mark:
    """Where a number is seen on the curve of the angle or of one of its derivatives."""

    sample: int  # of the segment, the nearest
    time: float  # s, on the segment's clock
    value: float  # rad, rad/s or rad/s^2


@dataclass(frozen=True)
class Measure:
    """`value` is None where the recording does not allow it; `reason` says why."""

    name: str
    title: str
    symbol: str
    unit: str
    value: float | None = None
    standard_error: float | None = None  # from the noise of the angle alone
    marks: tuple[Mark, ...] = ()
    reason: str | None = None


class NotAllowed(Exception):
    """What a recording lacks for a measure; it never leaves this folder."""


def given(found: Found | NotAllowed) -> Found:
    if isinstance(found, NotAllowed):
        raise found
    return found


def ordinal(number: int) -> str:
    return {1: "first", 2: "second", 3: "third", 4: "fourth"}.get(number, f"{number}th")
