"""What a reader says of a file: its rows, and whether it reports that anything is missing."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

Rows = Mapping[str, np.ndarray]  # columns by name


class Unread(Exception):
    """What an oracle does not know, of which it can therefore say nothing."""


@dataclass(frozen=True)
class Reading:
    """Rows, and what was said of them."""

    rows: Rows
    report: tuple[str, ...]


@dataclass(frozen=True)
class Sample:
    """A sound file, and what an oracle needs to know of how it was written."""

    content: bytes
    told: str = ""


@dataclass(frozen=True)
class Format:
    """A format as the fuzzer sees it."""

    suffix: str
    samples: tuple[Sample, ...]
    read: Callable[[Path], Reading]
    oracle: Callable[[Path, Sample], Rows] | None = None  # of another hand
    inside: Callable[..., bytes] | None = None  # damage below a checksum
    drawn: Callable[[Sample], Any] | None = None  # a strategy of hypothesis, which knows its fields
    checked: bool = False  # a checksum covers its numbers: other rows are wrong without an oracle
    stricter: bool = False  # the oracle refuses files whose rows it could tell


ROUNDING = 4e-16  # of a time that is made of two numbers


def alike(one: Rows, other: Rows) -> bool:
    """The same but for the last bit, which depends on the order of sums."""
    return one.keys() == other.keys() and all(
        one[name].shape == other[name].shape
        and (
            np.allclose(one[name], other[name], rtol=ROUNDING, atol=ROUNDING, equal_nan=True)
            if one[name].dtype.kind == "f"
            else np.array_equal(one[name], other[name])
        )
        for name in one
    )


def same(one: Rows, other: Rows) -> bool:
    """Are all columns alike, to the last bit?"""
    return one.keys() == other.keys() and all(
        np.array_equal(one[name], other[name], equal_nan=one[name].dtype.kind == "f")
        for name in one
    )
