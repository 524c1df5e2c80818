"""The sketch on the simulated board, here or on an emulated Cortex-M0: its fates and its words."""

import atexit
import shutil
import struct
import subprocess
import tempfile
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import can
import numpy as np
from firmware_tools import QEMU, make, need

from exoid.recordings.can.dbc import exoid_messages
from exoid.recordings.can.decode import raw_values
from exoid.recordings.can.node.samples import STATUS

KINDS = (
    *("SENSORS", "CLOCK_HELD", "CLOCK_HELD_AFTER", "DATA_HELD_AFTER", "GLITCH", "CONTROLLER"),
    *("ACKNOWLEDGED", "SHORTED", "FOREIGN", "USB_READS", "USB_PLUGGED", "USB_HELD", "TYPED"),
    *("TIMER_STANDS", "BROWN_OUT", "PASS", "QUIET", "END"),
)
ON_CAN, ON_USB, RESTARTED, LONGEST_PASS = range(4)
STATE, TIME = 0x101, 0x100
HEARD = np.dtype([("at_ms", "<u4"), ("link", "<u2"), ("id", "<u2"), ("data", "u1", 8)])

Event = tuple[int, str, int]  # ms, what, its value


@dataclass(frozen=True, eq=False)
class Life:
    """What was heard of a node, in the order of time."""

    records: np.ndarray

    def frames(self, identifier: int) -> np.ndarray:
        """The records of one message on CAN."""
        of_can = self.records[self.records["link"] == ON_CAN]
        return of_can[of_can["id"] == identifier]

    def signal(self, message: str, signal: str) -> np.ndarray:
        """A signal of every frame of a message on CAN, as it was sent."""
        plan = exoid_messages()[message]
        data = np.ascontiguousarray(self.frames(plan.identifier)["data"])
        return raw_values(data, plan.signal(signal)).astype(int)

    def told(self, since_ms: int = 0) -> set[str]:
        """The status bits that were ever set."""
        late = self.frames(STATE)["at_ms"] >= since_ms
        return {bit for bit in STATUS if self.signal("EXO_STATE", bit)[late].any()}

    @property
    def restarts(self) -> np.ndarray:
        return self.records[self.records["link"] == RESTARTED]

    @property
    def text(self) -> str:
        """What the host on USB read."""
        packets = self.records[self.records["link"] == ON_USB]
        return b"".join(bytes(row["data"][: row["id"]]) for row in packets).decode("ascii")

    @property
    def longest_pass(self) -> float:
        """Of the sketch's loop [s]."""
        last = self.records[-1]
        assert last["link"] == LONGEST_PASS
        return int(last["data"][:4].view("<u4")[0]) * 1e-6

    def log(self, path: Path) -> Path:
        """The frames on CAN as a candump log."""
        of_can = self.records[self.records["link"] == ON_CAN]
        with can.CanutilsLogWriter(path) as writer:
            for row in of_can:
                writer(
                    can.Message(
                        timestamp=1e9 + row["at_ms"] * 1e-3,
                        arbitration_id=int(row["id"]),
                        is_extended_id=False,
                        data=bytes(row["data"]),
                        is_rx=True,
                        channel="can0",
                    )
                )
        return path


def live(world: str, events: list[Event], folder: Path, *, limit: float = 100) -> Life:
    """The life of a node in one of the worlds: node_world, node_world_fast or node_world.elf."""
    records = b"".join(
        struct.pack("<IHH", at, KINDS.index(kind), value) for at, kind, value in events
    )
    (folder / "in.bin").write_bytes(records)
    program = program_of(world)
    command: list[str | Path] = [program]
    if world.endswith(".elf"):
        need("qemu-system-arm")
        command = [*QEMU, "-serial", "none", "-kernel", program]
    done = subprocess.run(command, cwd=folder, capture_output=True, timeout=limit)
    assert done.returncode == 0, f"{world} ended with {done.returncode}: {done.stderr.decode()}"
    return Life(np.fromfile(folder / "out.bin", HEARD))


@cache
def program_of(world: str) -> Path:
    """The program of a world, made once in a run of the tests."""
    folder = Path(tempfile.mkdtemp(prefix="exoid-firmware-"))
    atexit.register(shutil.rmtree, folder)
    return make(world, folder)
