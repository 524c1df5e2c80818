"""What every text format of frames asks of a line before it is read."""

import re
from collections.abc import Callable

Sound = Callable[[str], bool]  # is a line no frame, or one as whole as it was written?

HEX_BYTES = re.compile(r"(?:[0-9A-F]{2})*", re.ASCII | re.IGNORECASE)
STANDARD, EXTENDED = 0x7FF, 0x1FFFFFFF  # the largest identifiers


def sound_identifier(digits: str, extended: bool, base: int = 16) -> bool:
    """Is this an identifier that a frame can have?"""
    try:
        return int(digits, base) <= (EXTENDED if extended else STANDARD)
    except ValueError:
        return False
