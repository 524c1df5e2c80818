"""python-can's own CSV: every line below the first is a frame, its bytes in base 64."""

import re
from base64 import b64decode, b64encode
from binascii import Error
from collections.abc import Iterable

from exoid.recordings.can.logs.text.sound import Sound, sound_identifier

HEADER = "timestamp,arbitration_id,extended,remote,error,dlc,data"
FRAME = re.compile(
    r"\d+(?:\.\d+)?(?:e[+-]?\d+)?,0x(?P<id>[0-9a-f]+),(?P<extended>[01]),(?P<remote>[01]),"
    r"[01],(?P<length>\d{1,2}),(?P<data>[A-Za-z0-9+/=]*)",
    re.ASCII,
)


def csv_check(_lines: Iterable[str]) -> Sound:
    """Says of a line whether it is the header, or a frame as whole as it was written."""

    def sound(line: str) -> bool:
        if line == HEADER:
            return True
        found = FRAME.fullmatch(line)
        if found is None or not sound_identifier(found["id"], found["extended"] == "1"):
            return False
        try:
            data = b64decode(found["data"], validate=True)
        except Error:
            return False
        # Not every bit of the last letter before a `=` counts: it must be the one that is written.
        same = b64encode(data).decode() == found["data"]
        return same and (found["remote"] == "1" or len(data) == int(found["length"]))

    return sound
