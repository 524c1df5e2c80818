"""PEAK's TRC: a header that says its version, and from 2.0 its columns, then a line per frame."""

import re
from collections.abc import Iterable

from exoid.recordings.can.logs.text.sound import HEX_BYTES, Sound, sound_identifier

VERSION = re.compile(r"\s*;\$FILEVERSION=(\S+)\s*")
COLUMNS = re.compile(r"\s*;\$COLUMNS=(\S+)\s*")
BEGIN, END = r"\s*\d+\)\s+-?\d+(?:\.\d+)?\s+", r"(?P<length>\d{1,2})(?P<data>(?:\s.*)?)"
IDENTIFIER = r"(?P<id>[0-9A-F]{4}|[0-9A-F]{7,8})\s+"
EARLIER = {
    "1.1": rf"{BEGIN}(?P<kind>\w+)\s+{IDENTIFIER}{END}",
    "1.3": rf"{BEGIN}\d+\s+(?P<kind>\w+)\s+{IDENTIFIER}-\s+{END}",
}
FIRST = rf"{BEGIN}{IDENTIFIER}{END}"  # version 1.0, and a file that says none
CELLS = {
    "N": r"\d+",
    "O": r"-?\d+(?:\.\d+)?",
    "T": r"(?P<kind>\w\w)",
    "B": r"\d+",
    "I": r"(?P<id>-|[0-9A-F]{4}|[0-9A-F]{7,8})",
    "d": r"(?:Rx|Tx)",
    "l": r"(?P<length>\d{1,2})",
    "L": r"(?P<length>\d{1,2})",
    "D": r"(?P<data>.*)",
}  # by the letters of version 2
FRAMES = ("Rx", "Tx", "DT", None)
NO_FRAMES = ("Warng", "Error", "FD", "FB", "FE", "BI", "RR", "ST", "EC", "ER", "EV")
BUS = "FFFFFFFF"  # stands for an identifier where version 1.0 tells of the bus
SHORT = 4  # digits of an 11-bit identifier


def trc_check(lines: Iterable[str]) -> Sound:
    """Says of a line whether it is no data frame, or one as whole as it was written."""
    pattern = pattern_of([line for line in lines if line.lstrip().startswith(";$")])

    def sound(line: str) -> bool:
        if not line.strip() or line.lstrip().startswith(";"):
            return True
        found = pattern.fullmatch(line)
        if found is None:
            return False
        groups = found.groupdict()
        kind, identifier = groups.get("kind"), groups.get("id") or ""
        if kind in NO_FRAMES or (kind is None and identifier == BUS):
            return True
        if kind not in FRAMES or not sound_identifier(identifier, len(identifier) > SHORT):
            return False
        length, cells = groups.get("length"), (groups.get("data") or "").split()
        return cells == ["RTR"] or (
            length is not None
            and len(cells) == int(length)
            and all(len(cell) == 2 and HEX_BYTES.fullmatch(cell) for cell in cells)
        )

    return sound


def pattern_of(header: list[str]) -> re.Pattern[str]:
    """How a frame is written, as the header says."""
    told = [found[1] for line in header if (found := VERSION.fullmatch(line))]
    version = told[-1] if told else ""
    columns = [found[1].split(",") for line in header if (found := COLUMNS.fullmatch(line))]
    words = EARLIER.get(version, FIRST)
    if version.startswith("2") and columns:
        words = by_columns(columns[-1])
    return re.compile(words, re.ASCII | re.IGNORECASE)


def by_columns(letters: list[str]) -> str:
    """Cells between blanks; the last may be missing where it holds nothing."""
    named = {letter: CELLS.get(letter, r"\S+") for letter in dict.fromkeys(letters)}
    if {"l", "L"} <= named.keys():
        named["L"] = r"\d{1,2}"
    *cells, last = named.values()
    return r"\s*" + r"\s+".join(cells) + rf"(?:\s+{last})?"
