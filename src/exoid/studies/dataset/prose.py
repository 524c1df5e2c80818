"""Texts that lie among recordings and are none: notes, a protocol, a letter."""

from pathlib import Path

from exoid.recordings.formats.delimited import UTF_16
from exoid.recordings.tables.dialect import holds_table

ENDING = ".txt"  # of tables and of prose alike
BEGIN = 2**16  # bytes, within which a table has begun


def is_prose(path: Path) -> bool:
    """Is this a text without a table of numbers? One that is empty was to be a recording."""
    if path.suffix.lower() != ENDING:
        return False
    try:
        with path.open("rb") as file:
            begin = file.read(BEGIN)
    except OSError:  # of which its reader tells
        return False
    text = begin.decode("utf-16" if begin[:2] in UTF_16 else "latin-1", errors="replace")
    return bool(text.strip()) and "\0" not in text and not holds_table(text.splitlines())
