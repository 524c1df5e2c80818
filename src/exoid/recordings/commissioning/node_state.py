"""What a node tells of itself."""

from collections.abc import Mapping
from dataclasses import dataclass

from exoid.recordings.can.node.commissioned import PARTS, Mounting
from exoid.recordings.commissioning.told_parameters import HeldParameters


@dataclass(frozen=True)
class Health:
    """How a node is, by its EXO_HEARTBEAT and its EXO_HEALTH."""

    version: str
    supply: float  # V; 0 where it is not measured
    lost_frames: int
    sensor_fault: bool
    transmit_errors: int
    receive_errors: int
    can_off: bool
    on_can: bool

    def troubles(self) -> list[str]:
        """What is not as it should be."""
        counted = {
            "sensor fault": self.sensor_fault,
            "off the bus": self.can_off,
            f"{self.transmit_errors} transmit errors": self.transmit_errors,
            f"{self.receive_errors} receive errors": self.receive_errors,
            f"{self.lost_frames} frames lost": self.lost_frames,
        }
        return [trouble for trouble, there in counted.items() if there]


@dataclass(frozen=True)
class NodeState:
    """A node that was heard: who it is, how it was commissioned, how it is."""

    node: int
    serial: int
    mounting: Mounting
    commissioned: bool
    bit_rate: int  # bit/s
    changes: int
    health: Health | None
    parameters: HeldParameters | None = None  # of a torque

    def __str__(self) -> str:
        return f"node {self.node} (serial {self.serial:08X})"


def health_of(beat: Mapping[str, float], health: Mapping[str, float]) -> Health:
    """From the signals of EXO_HEARTBEAT and of EXO_HEALTH."""
    return Health(
        version=".".join(str(int(beat[part])) for part in PARTS),
        supply=round(beat["SupplyVoltage"], 2),
        lost_frames=int(beat["LostFrames"]),
        sensor_fault=bool(beat["SensorFault"]),
        transmit_errors=int(health["TransmitErrors"]),
        receive_errors=int(health["ReceiveErrors"]),
        can_off=bool(health["CanOff"]),
        on_can=bool(health["OnCan"]),
    )


def state_of(node: int, settings: Mapping[str, float], health: Health | None) -> NodeState:
    """From the signals of EXO_SETTINGS."""
    return NodeState(
        node=node,
        serial=int(settings["Serial"]),
        mounting=Mounting(int(settings["Zero"]), bool(settings["Reversed"])),
        commissioned=bool(settings["Commissioned"]),
        bit_rate=int(settings["BitRate"]),
        changes=int(settings["Changes"]),
        health=health,
    )
