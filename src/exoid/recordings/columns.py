"""The names of exoid's own columns, and what a name in a map of columns stands for."""

from dataclasses import dataclass
from math import pi

from exoid.recordings.declared.entry import known
from exoid.recordings.measured.segment import Segment

CHANNELS = {entry.metadata["column"]: entry.name for entry in known(Segment)}
UNITS = {entry.metadata["column"]: entry.metadata["unit"] for entry in known(Segment)}
IN_DEGREES = {name.replace("_rad", "_deg"): name for name in CHANNELS if "_rad" in name}
NUMERIC = {*CHANNELS, *IN_DEGREES, "segment"}
ANGLES = ("raw_angle_rad", "angle_rad")
SUFFIXES = ("_rad_s2", "_rad_s", "_rad", "_m_s2", "_nm", "_s")
OTHER_TIMES = {"time_ms": 1e-3, "time_us": 1e-6, "time_ns": 1e-9}
SEGMENT = "segment"


@dataclass(frozen=True)
class Target:
    """The column that another one becomes, and the size of its unit; None: the file says it."""

    column: str
    size: float | None


def stem(column: str) -> str:
    """An own column's name without its unit."""
    return column.removesuffix(next(each for each in SUFFIXES if column.endswith(each)))


def targets() -> dict[str, Target]:
    """Everything that may stand before the = of a map: with its unit, or without one."""
    found = {stem(name): Target(name, None) for name in CHANNELS}
    found |= {field: Target(name, None) for name, field in CHANNELS.items()}
    found |= {name: Target(name, 1.0) for name in CHANNELS}
    found |= {name: Target(own, pi / 180) for name, own in IN_DEGREES.items()}
    found |= {name: Target("time_s", size) for name, size in OTHER_TIMES.items()}
    return found | {SEGMENT: Target(SEGMENT, 1.0)}


TARGETS = targets()
