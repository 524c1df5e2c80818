"""Names that other programs give to time, knee angle, gyro and torque.

What is recognised is said; what could be two things is asked for. A velocity is only taken for a
gyro where it is called one: else it may be the slope of the angle, which tells nothing twice.
"""

import re
from collections import Counter

from exoid.recordings.columns import NUMERIC
from exoid.recordings.tables.sheet import Column
from exoid.recordings.tables.units import parted, size_of

SIDE = r"(?:left|right|links|rechts|l|r)"
# Quantity: what its names look like, the surest first. Names are in lower case, their words apart.
NAMES: dict[str, tuple[str, ...]] = {
    "time": (
        r"time|times|t|zeit|temps|tiempo|tempo",
        r"time ?stamps?|elapsed time|time elapsed|zeitstempel|(?:sample |sensor |seconds )?time|"
        r"seconds|secs?|uhrzeit|date ?time|messzeit|sampletimefine",
        r"ms|us|ns|m ?sec|usec|millis|micros|(?:milli|micro)seconds?",  # a logger's clock
    ),
    "angle": (
        rf"(?:{SIDE} )?knee ?(?:joint )?(?:flex(?:ion)?|extension|angles?)"
        rf"(?: (?:flex(?:ion)?|ext(?:ension)?|angles?|{SIDE}|x|value))*|"
        rf"(?:{SIDE})?knee ?angles? x|knee {SIDE} (?:flexion|angle)|"
        rf"jointset (?:\w+ )*knee angle {SIDE} value|"
        rf"(?:knie ?(?:gelenk)? ?(?:winkel|flexion|beugung)|angle (?:du )?genou|genou)(?: {SIDE})?",
        rf"knee(?: {SIDE})?|{SIDE} knee|knie",
        r"angle|winkel|encoder(?: angle)?|goniometer|joint angle|shank angle|pitch|phi|theta",
    ),
    "gyro": (
        r"gyro(?:scope)? knee|knee gyro(?:scope)?|shank gyro",
        r"(?:gyr|gyro|gyroscope|gyroskop)(?: ?[xyz])?(?: axis)?|[xyz] gyro",
    ),
    "torque": (
        r"(?:measured|applied|knee|joint)? ?(?:torque|drehmoment)",
    ),
    "segment": (r"segment|trial|drop|repetition|rep|versuch",),
}  # fmt: skip
# Names of many things, which are this one where they are in its unit: X [s], POSITION (DEGREES).
IN_ITS_UNIT = {"time": ("s", r"x"), "angle": ("rad", r"(?:joint )?pos(?:ition)?")}


def words(name: str) -> str:
    """A name in lower case, its words apart: RKneeAngles.X becomes r knee angles x."""
    name = re.sub(r"([a-z0-9])([A-Z])", r"\1 \2", name)
    name = re.sub(r"\b([LR])(?=Knee)", r"\1 ", name)
    return " ".join(re.split(r"[\W_]+", name.lower())).strip()


def spoken(name: str) -> set[str]:
    """The words of a name, and those of its last part where it is the field of a struct."""
    whole = parted(name)[0]
    return {words(whole), words(whole.rpartition(".")[2])}


def fits(name: str, pattern: str) -> bool:
    return any(re.fullmatch(pattern, each) for each in spoken(name))


def called(name: str, quantity: str) -> bool:
    """Is that what others call this quantity?"""
    return any(fits(name, pattern) for pattern in NAMES[quantity])


def recognised(columns: tuple[Column, ...], quantity: str) -> list[Column]:
    """The columns that are this quantity by their name, of the surest pattern that fits any."""
    for pattern in NAMES[quantity]:
        found = [
            column
            for column in columns
            if column.name not in NUMERIC and fits(column.name, pattern)
        ]
        if found:
            return found
    return in_its_unit(columns, quantity) if quantity in IN_ITS_UNIT else []


def in_its_unit(columns: tuple[Column, ...], quantity: str) -> list[Column]:
    """The columns of a vague name that are this quantity by their unit."""
    si, pattern = IN_ITS_UNIT[quantity]
    return [each for each in columns if fits(each.name, pattern) and size_of(each.unit, si)]


def main_size(vectors: list[Column]) -> int:
    """The length of the time or the angle, where one is told by its name; else of most vectors."""
    for quantity in ("time", "angle"):
        found = recognised(tuple(vectors), quantity)
        if found:
            return len(found[0].cells)
    return Counter(len(each.cells) for each in vectors).most_common(1)[0][0]
