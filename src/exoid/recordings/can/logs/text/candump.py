"""candump's log: every line is a frame."""

import re
from collections.abc import Iterable

from exoid.recordings.can.logs.text.sound import Sound, sound_identifier

FRAME = re.compile(
    r"\s*\(\d+\.\d+\)\s+\S+\s+(?P<id>[0-9A-F]{3}|[0-9A-F]{8})#"
    r"(?:(?:[0-9A-F]{2}){0,8}|R[0-8]?|#[0-9A-F](?:[0-9A-F]{2}){0,64})(?:\s+[RT])?\s*",
    re.ASCII | re.IGNORECASE,
)
SHORT = 3  # digits of an 11-bit identifier
ERROR = 0x20000000  # the bit that marks an error frame


def candump_check(_lines: Iterable[str]) -> Sound:
    """Says of a line whether it is empty, or a frame as whole as it was written."""

    def sound(line: str) -> bool:
        found = FRAME.fullmatch(line)
        if found is None:
            return not line.strip()
        number = int(found["id"], 16)
        error = len(found["id"]) > SHORT and number & ERROR and number < 2 * ERROR
        return bool(error) or sound_identifier(found["id"], len(found["id"]) > SHORT)

    return sound
