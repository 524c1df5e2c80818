"""Frames from an slcan adapter, line by line; a line that is no frame never passes for one.

python-can opens the adapter, but reads it byte by byte, completes lines that are cut, skips others
in silence, and keeps bytes that are no text in its buffer, where they spoil every line after them.
The lines are Lawicel's: `t` and `T` are data frames with an id of 11 and 29 bits, `r` and `R`
remote ones. CAN FD, which no node of ours sends, is not read.
"""

import re
import time
from collections import deque

import can

ENDS = re.compile(rb"[\r\a]")  # the adapter closes a line with CR, a refusal with BEL
FRAME = re.compile(
    rb"([trTR])((?<=[tr])[0-9A-Fa-f]{3}|(?<=[TR])[0-9A-Fa-f]{8})([0-8])((?:[0-9A-Fa-f]{2})*)"
)
ANSWERS = b"zZVvNF"  # to commands: they carry no frame
STAMP = 4  # digits that some adapters add, their own time: not used
LONGEST = 64  # bytes; no line is longer, so more without an end is noise


class SlcanPort:
    """The frames that arrive at a serial port which python-can has opened for slcan."""

    def __init__(self, port, patience: float):
        port.timeout = patience
        self.port = port
        self.lines: deque[bytes] = deque()
        self.rest = b""
        self.arrived = 0.0  # s, host time of what was read last
        self.begun = False

    def recv(self, timeout: float) -> can.Message | None:
        """The next frame; None where none came within the port's patience.

        **Raises** `ValueError` for a line that is no frame, `OSError` when the port is gone.
        """
        if not self.lines:
            self.read()
        while self.lines:
            line = self.lines.popleft()
            if line[:1] in ANSWERS:
                continue
            first, self.begun = not self.begun, True
            try:
                return parse(line, self.arrived)
            except ValueError:
                if not first:  # the first may be the end of a line that began before we listened
                    raise
        return None

    def read(self) -> None:
        """Take all that has arrived, and wait for the first byte of it."""
        chunk = self.port.read(1)
        if not chunk:
            return
        chunk += self.port.read(self.port.in_waiting)
        self.arrived = time.time()
        *lines, self.rest = ENDS.split(self.rest + chunk)
        self.lines.extend(lines)
        if len(self.rest) > LONGEST:
            self.lines.append(self.rest)
            self.rest = b""


def parse(line: bytes, arrived: float) -> can.Message:
    """The frame of a line. **Raises** `ValueError` where it is cut, or is none."""
    found = FRAME.fullmatch(line)
    if found is None:
        raise ValueError(f"{line[:LONGEST]!r} is no frame")
    kind, identifier, length, digits = found.groups()
    remote, count = kind in b"rR", int(length)
    size = 0 if remote else 2 * count
    if len(digits) not in (size, size + STAMP):
        raise ValueError(f"{line[:LONGEST]!r} is cut short or runs on")
    return can.Message(
        timestamp=arrived,
        arbitration_id=int(identifier, 16),
        is_extended_id=kind in b"TR",
        is_remote_frame=remote,
        dlc=count,
        data=None if remote else bytes.fromhex(digits[:size].decode()),
        check=True,
    )
