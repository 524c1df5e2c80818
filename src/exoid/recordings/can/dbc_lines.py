"""Lines of a DBC that are damaged, and that cantools reads in its own way, or cannot bear."""

import re

# cantools makes a mask of all bits of a message. J1939 has the longest, of 1785 bytes.
HUGE = re.compile(
    rb"^[ \t]*(?:BO_[ \t]+\d+|SG_)[ \t]+(\w+)[^\n:]*:[ \t]*(?:\d{1,6}\|)?0*[1-9]\d{4}", re.MULTILINE
)
# cantools takes any order but 0 for little-endian.
ODD_ORDER = re.compile(
    rb"^[ \t]*SG_[ \t]+(\w+)[^\n\"]*?:[^\n\"@]*@[ \t]*(?![01][ \t]*[+-])", re.MULTILINE
)
# And leaves a signal out where the file ends before its receivers.
LAST = re.compile(rb'^[ \t]*SG_[ \t]+(\w+)(?![^\n]*"[^"\n]*"[ \t]*\w)[^\n]*\s*\Z', re.MULTILINE)
BEGIN = re.compile(rb"^[ \t]*BO_[ \t]", re.MULTILINE)
PAGED = re.compile(rb"^[ \t]*SG_[ \t]+(\w+)[ \t]+m\d+M?[ \t]*:", re.MULTILINE)
PAGES = re.compile(rb"^[ \t]*SG_[ \t]+\w+[ \t]+(?:m\d+)?M[ \t]*:", re.MULTILINE)


def fault_of(content: bytes) -> str | None:
    """What is wrong with the lines of a DBC, and what to do; None where nothing is."""
    huge, odd, last = (each.search(content) for each in (HUGE, ODD_ORDER, LAST))
    if huge is not None:
        return f"says of {huge[1].decode()} a size that no message has."
    if odd is not None:
        return f"gives {odd[1].decode()} a byte order that is neither 0 nor 1. Is the line damaged?"
    if last is not None:
        return f"ends within the line of {last[1].decode()}. Copy it again."
    for message in BEGIN.split(content):
        paged = PAGED.search(message)
        if paged is not None and not PAGES.search(message):
            said = paged[1].decode()
            return f"has {said} in a page of a message without pages. Is a line missing?"
    return None
