"""The program beside the node: it hears what the node says, loads parameters, allows a torque.

It speaks to the node as `exoid.dbc` says, and forgets what it loaded where the leg is doubted.
"""

from dataclasses import dataclass

import can
import numpy as np
from benchmarks.closed_loop.node import SERIAL, Frame

from exoid.recordings.can.dbc import exoid_messages
from exoid.recordings.can.node.one_frame import values_of
from exoid.recordings.commissioning.commands import command
from exoid.recordings.commissioning.torque_parameters import PART, TorqueParameters

OFF, ARM, ENABLE = range(3)  # EXO_ALLOW.Wish
ENABLED = 2  # EXO_TORQUE.Permit
PERIOD = 2  # ticks between two EXO_ALLOW
NUMBERS = 16  # of EXO_ALLOW, which differ from frame to frame
RATIOS = "Gravity", "Stiffness", "Damping", "Torque"


@dataclass(frozen=True)
class Told:
    """What the node said last."""

    trust: int = 0
    drops: int = 0
    ratios: tuple[float, ...] = (0.0,) * len(RATIOS)
    friction: float = 0.0  # 1/s^2
    torque: float = 0.0  # N m; 0 unless it is enabled
    permit: int = 0
    crc: int = 0  # of the parameters that the node holds


class Host:
    """One such program."""

    def __init__(self) -> None:
        self.told = Told()
        self.wants = False  # a torque
        self.limit = 0.0  # N m, beside that of the parameters
        self._loads: list[can.Message] = []
        self._loaded: TorqueParameters | None = None
        self._number = self._tick = 0

    def load(self, parameters: TorqueParameters, limit: float) -> None:
        """Has the node go by these, and within that limit."""
        parameters.check()
        self._loaded, self.limit = parameters, limit
        parts = np.frombuffer(parameters.data, f"<u{PART}").tolist()
        self._loads = [
            command("EXO_LOAD", SERIAL, Place=place, Data=data)
            for place, data in enumerate([*parts, parameters.crc])
        ]

    def forget(self) -> None:
        """The parameters are nobody's: no torque until others are loaded."""
        self._loaded, self._loads = None, []

    def see(self, frames: list[Frame]) -> None:
        """What the node sent in a tick. A torque is what that tick's EXO_TORQUE says, or none."""
        said = {"torque": 0.0, "permit": 0}
        for frame in frames:
            name = NAMES.get(frame.identifier)
            if name is not None:
                said |= READERS[name](frame.data)
        self.told = Told(**vars(self.told) | said)

    def say(self) -> list[can.Message]:
        """What it sends in a tick."""
        self._tick += 1
        if self._loads:
            return [self._loads.pop(0)]
        if self._tick % PERIOD:
            return []
        self._number = (self._number + 1) % NUMBERS
        wish = OFF
        if self.wants and self._loaded is not None and self.told.crc == self._loaded.crc:
            wish = ENABLE if self.told.permit else ARM
        said = {"Wish": wish, "Number": self._number, "Limit": self.limit}
        return [command("EXO_ALLOW", SERIAL, **said)]


def ratios(data: bytes) -> dict:
    return {"ratios": values_of(exoid_messages()["EXO_RATIOS"], data, RATIOS)}


def friction(data: bytes) -> dict:
    return {"friction": values_of(exoid_messages()["EXO_FRICTION"], data, ("Friction",))[0]}


def learning(data: bytes) -> dict:
    trust, drops = values_of(exoid_messages()["EXO_LEARNING"], data, ("Trust", "Drops"))
    return {"trust": int(trust), "drops": int(drops)}


def torque(data: bytes) -> dict:
    names = "Torque", "Permit", "Crc"
    value, permit, crc = values_of(exoid_messages()["EXO_TORQUE"], data, names)
    return {
        "torque": value if permit == ENABLED else 0.0,
        "permit": int(permit),
        "crc": int(crc),
    }


READERS = {
    "EXO_RATIOS": ratios,
    "EXO_FRICTION": friction,
    "EXO_LEARNING": learning,
    "EXO_TORQUE": torque,
}
NAMES = {exoid_messages()[name].identifier: name for name in READERS}
