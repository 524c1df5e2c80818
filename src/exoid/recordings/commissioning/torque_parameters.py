"""The parameters by which a node commands a torque, as it takes them from a host."""

import struct
from binascii import crc_hqx
from dataclasses import astuple, dataclass, field, fields
from math import pi
from typing import Any

from exoid.recordings.can.node.config_crc import SEED

PART = 2  # bytes of them in a frame


def number(unit: str, lower: float, upper: float, note: str) -> Any:
    """A number with its unit, what a leg's and a small motor's lie between, and its meaning."""
    return field(metadata={"unit": unit, "lower": lower, "upper": upper, "note": note})


@dataclass(frozen=True)
class TorqueParameters:
    """A leg of J phi'' = tau - m l g cos(phi + thigh) - c phi - d phi' - friction sign(phi').

    What of it the motor takes off, and how much torque there may be; in the order of their frames.
    """

    gravity: float = number("N m", 0.0, 60.0, "m l g")
    thigh_angle: float = number("rad", -pi / 2, pi / 2, "of the thigh above level")
    stiffness: float = number("N m/rad", 0.0, 60.0, "c")
    damping: float = number("N m s/rad", 0.0, 10.0, "d")
    friction: float = number("N m", 0.0, 10.0, "dry")
    inertia: float = number("kg m^2", 0.0, 2.0, "J")
    gravity_share: float = number("", 0.0, 1.0, "of gravity that is taken off: 0 nothing, 1 all")
    stiffness_share: float = number("", 0.0, 1.0, "the same of stiffness")
    damping_share: float = number("", 0.0, 1.0, "the same of damping")
    friction_share: float = number("", 0.0, 1.0, "the same of dry friction")
    limit: float = number("N m", 0.0, 15.75, "of the torque, either way")
    rate_limit: float = number("N m/s", 0.0, 100.0, "of its change, but for the fall to 0")

    @property
    def data(self) -> bytes:
        """Their float32, as the node keeps them."""
        return struct.pack(LAYOUT, *astuple(self))

    @property
    def crc(self) -> int:
        return crc_hqx(self.data, layout_crc())

    def check(self) -> None:
        """**Raises** `ValueError` for a number that the node does not take."""
        rounded = from_data(self.data)  # as it is compared there
        for each in fields(self):
            value, (lower, upper) = getattr(rounded, each.name), bounds(each)
            if not lower <= value <= upper:
                raise ValueError(
                    f"{each.name} = {getattr(self, each.name):g} {each.metadata['unit']}: a node "
                    f"takes {lower:g} to {upper:g}."
                )


LAYOUT = f"<{len(fields(TorqueParameters))}f"
PARTS = struct.calcsize(LAYOUT) // PART  # of frames, but for the last one with the CRC


def bounds(each: Any) -> tuple[float, float]:
    """Between what the node takes a number: those of its unit, rounded to float32."""
    lower, upper = struct.unpack("<2f", struct.pack("<2f", *map(each.metadata.get, ENDS)))
    return lower, upper


ENDS = ("lower", "upper")


def from_data(data: bytes) -> TorqueParameters:
    return TorqueParameters(*struct.unpack(LAYOUT, data))


def layout_crc() -> int:
    """What the CRC of parameters begins with, so that those of another layout have another one."""
    lines = (f"{each.name} {each.metadata['unit']}" for each in fields(TorqueParameters))
    return crc_hqx("\n".join(lines).encode(), SEED)
