"""One and many, as a sentence has them."""

from typing import SupportsIndex


def counted(count: SupportsIndex, one: str, many: str = "") -> str:
    """A number with its noun."""
    return f"{count} {one if count == 1 else many or one + 's'}"
