"""One and many, as a sentence has them."""

from collections.abc import Sequence
from typing import SupportsIndex


def counted(count: SupportsIndex, one: str, many: str = "") -> str:
    """A number with its noun."""
    return f"{count} {one if count == 1 else many or one + 's'}"


def some_of(each: Sequence[str], shown: int, more: str) -> str:
    """The first few of a list, and how many there are beyond them."""
    beyond = f", and {len(each) - shown} {more}" if len(each) > shown else ""
    return ", ".join(each[:shown]) + beyond
