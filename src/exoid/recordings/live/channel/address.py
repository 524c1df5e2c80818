"""Which bus is meant, and the error of one that cannot be used."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any


class CanBusError(ValueError):
    """A bus that cannot be used, in one line: what is wrong, where, and what to do."""


@dataclass(frozen=True)
class BusAddress:
    """Which bus: python-can's interface and channel, the bit rate [bit/s], further options."""

    interface: str
    channel: str
    bitrate: int
    options: Mapping[str, Any] = field(default_factory=dict)

    def __str__(self) -> str:
        return f"{self.interface} {self.channel}"
