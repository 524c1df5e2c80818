"""The units a DBC may give its signals in, and what they are in SI."""

from math import pi

from exoid.recordings.can.frames import CanLogError

DEGREE = pi / 180
GRAVITY = 9.80665  # m/s^2, the standard one that sensors are specified in

# SI unit of a channel: {unit as DBC files write it, in lower case without blanks: its size in SI}
UNITS: dict[str, dict[str, float]] = {
    "rad": {"rad": 1.0, "mrad": 1e-3, "deg": DEGREE, "degree": DEGREE, "degrees": DEGREE,
            "°": DEGREE, "rev": 2 * pi, "turn": 2 * pi},
    "rad/s": {"rad/s": 1.0, "mrad/s": 1e-3, "deg/s": DEGREE, "degree/s": DEGREE, "dps": DEGREE,
              "°/s": DEGREE, "deg/sec": DEGREE, "mdps": DEGREE * 1e-3, "rpm": 2 * pi / 60,
              "1/min": 2 * pi / 60},
    "rad/s^2": {"rad/s^2": 1.0, "rad/s2": 1.0, "rad/s²": 1.0, "rad/s/s": 1.0, "deg/s^2": DEGREE,
                "deg/s2": DEGREE, "deg/s²": DEGREE, "°/s²": DEGREE, "°/s^2": DEGREE},
    "m/s^2": {"m/s^2": 1.0, "m/s2": 1.0, "m/s²": 1.0, "m/s/s": 1.0, "g": GRAVITY,
              "mg": GRAVITY * 1e-3},
    "N m": {"nm": 1.0, "n.m": 1.0, "n-m": 1.0, "n*m": 1.0, "n·m": 1.0, "mnm": 1e-3, "n.mm": 1e-3},
}  # fmt: skip


def size_in(si: str, unit: str, where: str) -> float:
    """What one `unit` is in the SI unit.

    **Raises** `CanLogError` for a unit that is absent, unknown, or of another quantity.
    """
    known = UNITS[si]
    plain = "".join(unit.lower().split())
    if plain not in known:
        told = f"has the unit {unit!r}" if unit else "has no unit"
        raise CanLogError(
            f"{where} {told}, but {si} is wanted, or one of {', '.join(known)}. "
            f'Name the true unit in the map: "{where} [{next(iter(known))}]".'
        )
    return known[plain]
