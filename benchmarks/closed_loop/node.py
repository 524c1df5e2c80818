"""The node's own C++, compiled for this machine: readings go in at each tick, frames come out."""

import ctypes
import subprocess
import tempfile
from functools import cache
from pathlib import Path
from typing import NamedTuple
from weakref import finalize

import can

HERE = Path(__file__).parent
SOURCES = HERE.parents[1] / "firmware" / "exoid_node" / "src"
SERIAL = 1
TICK = 0.01  # s
MOST = 32  # frames of a tick


class Readings(ctypes.Structure):
    """What the chips say at a tick, in their own counts and axes."""

    _fields_ = [
        ("count", ctypes.c_uint16),
        ("gyro", ctypes.c_int16 * 3),
        ("acceleration", ctypes.c_int16 * 3),
    ]


class RawFrame(ctypes.Structure):
    _fields_ = [("identifier", ctypes.c_uint16), ("data", ctypes.c_uint8 * 8)]


class Frame(NamedTuple):
    """A frame that the node sent."""

    identifier: int
    data: bytes


class Node:
    """One node, as it is after a start."""

    def __init__(self) -> None:
        self._code = library()
        self._node = ctypes.c_void_p(self._code.node_new())
        self._sent = (RawFrame * MOST)()
        finalize(self, self._code.node_free, self._node)

    def hear(self, message: can.Message) -> None:
        """A command of the host's, which the node takes at its next tick."""
        data = (ctypes.c_uint8 * 8)(*message.data)
        raw = RawFrame(message.arbitration_id, data)
        self._code.node_hear(self._node, ctypes.byref(raw))

    def tick(self, readings: Readings) -> list[Frame]:
        """What it sends in the tick that begins with these readings."""
        given = ctypes.byref(readings)
        count = self._code.node_tick(self._node, given, self._sent, MOST)
        return [Frame(each.identifier, bytes(each.data)) for each in self._sent[:count]]


@cache
def library() -> ctypes.CDLL:
    """The node's sources with `node.cpp`, compiled as for the tests that compare it bit by bit."""
    with tempfile.TemporaryDirectory() as folder:
        compiled = Path(folder) / "node.so"
        flags = ["-std=c++11", "-O2", "-ffp-contract=off", "-shared", "-fPIC", f"-I{SOURCES}"]
        subprocess.run(["g++", *flags, HERE / "node.cpp", "-o", compiled], check=True)
        code = ctypes.CDLL(str(compiled))
    code.node_new.restype = ctypes.c_void_p
    code.node_free.restype = None
    code.node_hear.restype = None
    code.node_tick.restype = ctypes.c_uint32
    return code
