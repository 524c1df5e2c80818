"""Vector's ASC: which of its lines are frames, and which of these are whole."""

import re
from collections.abc import Iterable

from exoid.recordings.can.logs.text.sound import Sound, sound_identifier

BASE = re.compile(r"\s*base\s+(hex|dec)\b", re.IGNORECASE)
# What a frame may look like with one of its letters damaged; other events are no frames.
ALIKE = re.compile(
    r"\s*\d+\.\d+\s+\d+\s+\w+\s+(?:Tx|Rx)|\s(?:Rx|Tx|TxRq)\s+[dr]\b|\sd\s+[0-9a-f]\s",
    re.ASCII | re.IGNORECASE,
)
OTHERS = re.compile(
    r"\sJ1939TP\s|^\s*\d+\.\d+\s+(?:CANFD\s+\d+\s+(?:Rx|Tx)|\d+\s+Statistic:)\s|^\s*//", re.ASCII
)
FRAME = re.compile(
    r"\s*\d+\.\d+\s+\d+\s+(?P<id>[0-9A-F]+)(?P<x>x?)\s+(?:Rx|Tx|TxRq)\s+"
    r"(?:r\b.*|d\s+(?P<length>[0-9A-F])(?P<data>(?:\s.*)?))",
    re.ASCII | re.IGNORECASE,
)
BYTES = {
    16: (re.compile(r"[0-9A-F]{2}", re.ASCII | re.IGNORECASE), re.compile(r"[0-9A-Fa-f]{1,2}")),
    10: (re.compile(r"\d{1,3}", re.ASCII), re.compile(r"\d{1,3}", re.ASCII)),
}  # a byte as it is written, and what could have been one
LONGEST = 8
EVENT = re.compile(r"\s*\d+\.\d+\s", re.ASCII)


def base_of(lines: Iterable[str]) -> str:
    """`hex` or `dec`: how ids and bytes are written, as the lines above the frames say."""
    for line in lines:
        if found := BASE.match(line):
            return found[1].lower()
        if is_event(line):
            break
    return "hex"


def is_alike(line: str) -> bool:
    """Is this a frame, or was it one?"""
    return bool(ALIKE.search(line)) and not OTHERS.search(line)


def is_event(line: str) -> bool:
    """Does a time stand at its begin, as in no line of a header?"""
    return EVENT.match(line) is not None


def asc_check(lines: Iterable[str]) -> Sound:
    """Says of a line whether it is no frame, or one as whole as it was written."""
    base = 10 if base_of(lines) == "dec" else 16

    def sound(line: str) -> bool:
        if not is_alike(line):
            return True
        found = FRAME.fullmatch(line)
        if found is None or not sound_identifier(found["id"], bool(found["x"]), base):
            return False
        return found["length"] is None or whole(found["data"], int(found["length"], 16), base)

    return sound


def whole(data: str, length: int, base: int) -> bool:
    """Are there as many bytes as were announced, each as it is written, and no further one?"""
    cells, (byte, alike) = data.split(), BYTES[base]
    count = next((at for at, cell in enumerate(cells) if not alike.fullmatch(cell)), len(cells))
    told = cells[:count]
    return count == min(length, LONGEST) and all(
        byte.fullmatch(cell) and int(cell, base) < 256 for cell in told
    )
