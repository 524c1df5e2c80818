"""The parameters of a torque as a node tells them, one after the other."""

from collections.abc import Mapping
from dataclasses import dataclass, fields

import numpy as np

from exoid.recordings.commissioning.torque_parameters import TorqueParameters


@dataclass(frozen=True)
class HeldParameters:
    """What a node holds."""

    values: TorqueParameters
    crc: int
    stored: bool  # over a loss of power

    @property
    def whole(self) -> bool:
        """Whether they have the CRC that the node tells: else its layout is not this exoid's."""
        return self.values.crc == self.crc

    def lines(self) -> list[str]:
        """Each with its unit."""
        return [
            f"{each.name.replace('_', ' ')} {getattr(self.values, each.name):g} "
            f"{each.metadata['unit']}".rstrip()
            for each in fields(TorqueParameters)
        ]


class ToldParameters:
    """Gathers them from EXO_PARAMETER; others than before begin anew."""

    def __init__(self):
        self.values: dict[int, float] = {}
        self.last: Mapping[str, float] = {"Crc": -1.0}

    def hear(self, frame: Mapping[str, float]) -> None:
        if frame["Crc"] != self.last["Crc"]:
            self.values = {}
        self.values[int(frame["Place"])] = float(np.float32(frame["Value"]))
        self.last = frame

    def held(self) -> HeldParameters | None:
        """Once all are told."""
        places = range(len(fields(TorqueParameters)))
        if not all(place in self.values for place in places):
            return None
        values = TorqueParameters(*(self.values[place] for place in places))
        return HeldParameters(values, int(self.last["Crc"]), bool(self.last["Stored"]))
