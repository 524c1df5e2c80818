"""Nodes on python-can's virtual bus: they obey commands as exoid.dbc describes them."""

import struct
import threading
from binascii import crc_hqx
from dataclasses import dataclass, field

import can
from cantools.database import load_file
from cantools.database.can import Database

from exoid.recordings.can.dbc import EXOID_DBC

STRIDE = 16  # identifiers from one node to the next
SEED = 0xFFFF  # of CRC-16/CCITT-FALSE
COUNT = 4096 / 6.283185307179586  # counts of a radian
BEAT = {
    "VersionMajor": 1,
    "VersionMinor": 2,
    "VersionPatch": 3,
    "SupplyVoltage": 3.26,
    "LostFrames": 0,
    "SensorFault": 0,
}
FLAGS = ("NoAngle", "NotPossible", "NotStored", "NotWhole", "NotPlausible")
PLACES = 12  # parameters of a torque
LAYOUT_CRC = 0x6447  # of their names and units
SILENT = ("EXO_ALLOW",)  # what no node answers


@dataclass
class FakeNode:
    """A node with its encoder at `count`; `fails` names the flag with which it replies."""

    serial: int
    node: int = 0
    count: int = 1000
    zero: int = 2048
    reversed: bool = False
    bit_rate: int = 500_000
    changes: int = 0
    velocity: float = 0.0  # rad/s
    fails: str | None = None
    deaf: dict[str, int] = field(default_factory=dict)  # how many of a command it misses
    blinks: int = 0  # s
    answers: bool = True  # else it only measures, as older firmware does
    measures: bool = True  # else it only answers
    errors: int = 0
    parts: bytes = b""  # of parameters that come
    held: bytes = b""  # the parameters of a torque
    told: int = 0  # place of the one that is told next
    permit: int = 0
    torque: float = 0.5  # N m, once it is enabled
    doubts: int = 0  # what stands against arming it
    cuts: int = 0  # what cuts it
    enabled_for: int = 100  # frames that enable it before it is cut
    asked: bool = False
    wishes: list[int] = field(default_factory=list)
    limits: set[float] = field(default_factory=set)  # N m

    def obey(self, name: str, values: dict) -> bool:
        """Whether it was for this node."""
        if values["Serial"] not in (self.serial, *([0] if name == "EXO_TELL" else [])):
            return False
        if self.deaf.get(name):
            self.deaf[name] -= 1
            return False
        if not self.fails:
            self.change(name, values)
        return True

    def change(self, name: str, values: dict) -> None:
        before = (self.zero, self.reversed, self.node, self.bit_rate)
        if name == "EXO_SET_ZERO":
            sign = -1 if self.reversed else 1
            self.zero = (self.count - sign * round(values["Angle"] * COUNT)) % 4096
        elif name == "EXO_SET_DIRECTION":
            self.reversed = bool(values["Reversed"])
        elif name == "EXO_SET_NODE_ID":
            self.node = int(values["NodeId"])
        elif name == "EXO_SET_BIT_RATE":
            self.bit_rate = int(values["BitRate"])
        elif name == "EXO_LOAD":
            self.load(values["Place"], values["Data"])
        elif name == "EXO_ALLOW":
            self.allow(values)
        elif name == "EXO_IDENTIFY":
            self.blinks = int(values["Duration"])
        self.changes += (self.zero, self.reversed, self.node, self.bit_rate) != before

    def load(self, place: int, data: int) -> None:
        """Parts in their order, and last their CRC; what is wrong is told as `fails`, once."""
        self.parts = self.parts[: 2 * place]
        if len(self.parts) < 2 * place or (
            place == 2 * PLACES and data != crc_hqx(self.parts, LAYOUT_CRC)
        ):
            self.parts, self.fails = b"", "NotWhole"
        elif place == 2 * PLACES:
            self.held = self.parts
        else:
            self.parts += data.to_bytes(2, "little")

    def allow(self, values: dict) -> None:
        self.asked = True
        self.wishes.append(values["Wish"])
        self.limits.add(values["Limit"])
        if values["Wish"] == 0 or self.doubts:
            self.permit = 0
        elif values["Wish"] == 1:
            self.permit = 1
        elif self.permit:
            self.permit = 2
            self.enabled_for -= 1
            if self.cuts and self.enabled_for <= 0:
                self.permit, self.doubts = 0, self.cuts

    def commands(self) -> list[tuple[str, dict]]:
        """What it sends of a torque at a tick."""
        found = []
        crc = crc_hqx(self.held, LAYOUT_CRC) if self.held else 0
        if self.held or self.asked:
            torque = self.torque if self.permit == 2 else 0.0
            told = {"Torque": torque, "Counter": 0, "Permit": self.permit}
            found.append(("EXO_TORQUE", told | {"Doubts": self.doubts, "Crc": crc}))
        if self.held:
            (value,) = struct.unpack_from("<f", self.held, 4 * self.told)
            told = {"Place": self.told, "Stored": 1, "Value": value, "Crc": crc}
            found.append(("EXO_PARAMETER", told))
            self.told = (self.told + 1) % PLACES
        return found

    def says(self, command: int) -> list[tuple[str, dict]]:
        """What it sends after a command: reply, settings, heartbeat, health."""
        reply = {"Serial": self.serial, "Command": command, **dict.fromkeys(FLAGS, 0)}
        if self.fails and command != 0x200:
            reply[self.fails] = 1
            self.fails = None if self.fails == "NotWhole" else self.fails
        settings = {
            "Serial": self.serial,
            "Zero": self.zero,
            "Reversed": self.reversed,
            "Commissioned": self.changes > 0,
            "BitRate": self.bit_rate,
            "Changes": self.changes,
        }
        return [
            ("EXO_REPLY", reply),
            ("EXO_SETTINGS", settings),
            ("EXO_HEARTBEAT", BEAT),
            ("EXO_HEALTH", self.health()),
        ]

    def health(self) -> dict:
        return {
            "Counter": 0,
            "WatchdogReset": 0,
            "BrownOutReset": 0,
            "OnCan": 1,
            "CanOff": 0,
            "BusReleases": 0,
            "CanStarts": 1,
            "TransmitErrors": self.errors,
            "ReceiveErrors": 0,
        }


class FakeBus:
    """Nodes on a virtual bus, each with a STATE a hundred times a second."""

    def __init__(self, channel: str, *nodes: FakeNode):
        database = load_file(EXOID_DBC)
        assert isinstance(database, Database)
        self.database = database
        self.nodes = nodes
        self.heard: list[str] = []
        self.bus = can.Bus(interface="virtual", channel=channel)
        self.over = threading.Event()
        self.thread = threading.Thread(target=self.run, daemon=True)
        self.thread.start()

    def close(self) -> None:
        self.over.set()
        self.thread.join()
        self.bus.shutdown()

    def run(self) -> None:
        while not self.over.is_set():
            message = self.bus.recv(0.01)
            if message is not None:
                self.take(message)
            for node in self.nodes:
                if node.measures:
                    self.send(node, "EXO_STATE", self.state(node))
                for name, said in node.commands():
                    self.send(node, name, said)

    def take(self, message: can.Message) -> None:
        definition = self.database.get_message_by_frame_id(message.arbitration_id)
        assert definition.senders == ["HOST"]
        assert crc_hqx(bytes(message.data[:7]), SEED) & 0xFF == message.data[7]
        values = definition.decode(bytes(message.data))
        self.heard.append(definition.name)
        for node in self.nodes:
            obeys = node.answers and node.obey(definition.name, values)
            if obeys and definition.name not in SILENT:
                for name, said in node.says(message.arbitration_id):
                    self.send(node, name, said)

    def state(self, node: FakeNode) -> dict:
        signals = self.database.get_message_by_name("EXO_STATE").signals
        return {signal.name: 0 for signal in signals} | {"AngularVelocity": node.velocity}

    def send(self, node: FakeNode, name: str, values: dict) -> None:
        definition = self.database.get_message_by_name(name)
        identifier = definition.frame_id + STRIDE * node.node
        data = definition.encode(values)
        self.bus.send(can.Message(arbitration_id=identifier, is_extended_id=False, data=data))
