"""Units as people write them beside a name or in a row of their own, and their sizes in SI."""

import re

from exoid.recordings.can.units import UNITS

TIMES = {
    "s": 1.0, "sec": 1.0, "secs": 1.0, "second": 1.0, "seconds": 1.0, "sek": 1.0, "sekunden": 1.0,
    "ms": 1e-3, "msec": 1e-3, "millisecond": 1e-3, "milliseconds": 1e-3, "millis": 1e-3,
    "us": 1e-6, "µs": 1e-6, "μs": 1e-6, "usec": 1e-6, "microsecond": 1e-6,
    "microseconds": 1e-6, "micros": 1e-6, "ns": 1e-9,
    "min": 60.0, "minutes": 60.0,
}  # fmt: skip
DEGREE = UNITS["rad"]["°"]
MORE = {  # German writes degrees as Grad; a gon is nowhere in use on legs
    "rad": {"radian": 1.0, "radians": 1.0, "degs": DEGREE, "grad": DEGREE, "º": DEGREE},
    "rad/s": {"rad/sec": 1.0, "degrees/s": DEGREE, "grad/s": DEGREE, "º/s": DEGREE},
}
SIZES = {"s": TIMES, **UNITS} | {si: UNITS[si] | MORE[si] for si in MORE}
OTHERS = {"m", "mm", "cm", "n", "v", "mv", "uv", "hz", "%", "w", "bw", "kg", "counts", "n/a"}
ALL = {name for sizes in SIZES.values() for name in sizes} | OTHERS
BRACKETED = re.compile(r"^(?P<name>.*?)\s*[\[(]\s*(?P<unit>[^\[\]()]*?)\s*[\])]$", re.DOTALL)
SEPARATED = re.compile(r"^(?P<name>.+?)(?:\s*/\s*|\s+in\s+|\s+)(?P<unit>\S+)$", re.DOTALL)
SUFFIXED = {
    "_deg_s2": "deg/s2", "_rad_s2": "rad/s2", "_m_s2": "m/s2",
    "_deg_s": "deg/s", "_rad_s": "rad/s", "_dps": "deg/s", "_degs": "deg/s",
    "_deg": "deg", "_rad": "rad", "_degrees": "deg", "_radians": "rad",
    "_ms": "ms", "_us": "us", "_ns": "ns", "_sec": "s", "_s": "s", "_nm": "nm",
}  # fmt: skip


def plain(unit: str) -> str:
    """A unit in lower case, without brackets and blanks."""
    return "".join(unit.lower().split()).strip("[]()")


def is_unit(text: str) -> bool:
    return plain(text) in ALL


def parted(name: str) -> tuple[str, str]:
    """A name and the unit that is written behind it, "" where none is.

    Time (s), Winkel [°], t/ms, Winkel in deg, knee_angle_deg, gyro_z_deg/s.
    """
    found = BRACKETED.match(name)
    if found and is_unit(found["unit"]):
        return found["name"], found["unit"]
    shorter, _, unit = name.rpartition("_")
    if shorter and "/" in unit and is_unit(unit):
        return shorter, unit
    found = SEPARATED.match(name)
    if found and is_unit(found["unit"]):
        return found["name"], found["unit"]
    for suffix, unit in SUFFIXED.items():
        if name.lower().endswith(suffix) and len(name) > len(suffix):
            return name[: -len(suffix)], unit
    return name, plain(name) if plain(name) in TIMES else ""  # a clock that is called by its unit


def size_of(unit: str, si: str) -> float | None:
    """What one `unit` is in the SI unit; None where it is of another quantity, or not known."""
    return SIZES.get(si, {}).get(plain(unit))
