"""Standard streams that end no command: who reads them may be gone, or keep them on a full disk.

What a command finds goes to files as well as to a terminal. Words that nobody takes any more must
not take the files with them.
"""

import os
import sys
from io import BufferedWriter, FileIO, TextIOWrapper

STREAMS = (0, 1, 2)  # of every process
UNWRITABLE = "backslashreplace"  # a sign that the encoding of a terminal lacks stops no table
WRITTEN = {"stdout": 1, "stderr": 2}


class Lasting(FileIO):
    """A stream of this process that takes everything, and remembers why it could not pass it on."""

    fault: OSError | None = None
    terminal = False  # a window that is closed

    def write(self, content, /) -> int:
        """All of it counts as written, from the first failure on."""
        try:
            return super().write(content) if self.fault is None else memoryview(content).nbytes
        except OSError as fault:
            self.fault = fault
            return memoryview(content).nbytes


def outlast_readers() -> None:
    """Let nothing that is said from now on end this process, whoever reads it."""
    for number in STREAMS:
        open_closed(number)
    if sys.stdin is None:
        sys.stdin = TextIOWrapper(FileIO(STREAMS[0], closefd=False))
    for name, number in WRITTEN.items():
        found = getattr(sys, name)
        if found is None:
            setattr(sys, name, lasting(number, "utf-8"))
        elif type(raw_of(found)) is FileIO:
            found.flush()
            setattr(sys, name, lasting(number, found.encoding))


def open_closed(number: int) -> None:
    """A file that is opened later must not take the number of a stream that was closed."""
    try:
        os.fstat(number)
    except OSError:
        os.open(os.devnull, os.O_RDWR)


def lasting(number: int, encoding: str) -> TextIOWrapper:
    raw = Lasting(number, "w", closefd=False)
    raw.terminal = raw.isatty()
    lines = number == WRITTEN["stderr"] or raw.terminal
    return TextIOWrapper(
        BufferedWriter(raw), encoding=encoding, errors=UNWRITABLE, line_buffering=lines
    )


def raw_of(stream) -> object:
    """What a text stream writes to in the end; unbuffered, its buffer is that itself."""
    buffer = getattr(stream, "buffer", None)
    return getattr(buffer, "raw", buffer)


def lost_output() -> OSError | None:
    """Why what was said on stdout is not whole; a reader who has seen enough lacks nothing, and one
    whose terminal is closed cannot be told.
    """
    sys.stdout.flush()
    raw = raw_of(sys.stdout)
    if not isinstance(raw, Lasting) or raw.terminal or isinstance(raw.fault, BrokenPipeError):
        return None
    return raw.fault
