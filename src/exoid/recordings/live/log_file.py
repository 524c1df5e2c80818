"""The log that a live recording writes: at any moment, all but the last half second is on disk."""

import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

import can

from exoid.recordings.can.frames import CanLogError

SAVED_EVERY = 0.5  # s
KINDS = (".blf", ".asc", ".log")


def check_kind(path: Path) -> None:
    """**Raises** `CanLogError` for a format that a recording is not written in."""
    kind = path.suffix.lower()
    if kind == ".db":
        raise CanLogError(
            f"{path}: python-can loses frames when it writes .db. End it in {', '.join(KINDS)}."
        )
    if kind not in KINDS:
        raise CanLogError(f"{path}: a recording ends in {', '.join(KINDS)}. Name such a file.")


class LogFile:
    """A log file that comes into being with its first frame.

    **Raises** `FileExistsError` at the first frame where there is such a file and it is not to be
    replaced, and `CanLogError` where a frame cannot be written.
    """

    def __init__(self, path: Path, *, replace: bool = False):
        check_kind(path)
        self.path = path
        self.replace = replace
        self.writer: Any = None
        self.frames = 0
        self.saved = time.monotonic()

    def write(self, message: can.Message) -> None:
        """Add a frame, and twice a second hand over all of them to the operating system."""
        with self.whole():
            if self.writer is None:
                self.writer = begin(self.path, "w" if self.replace else "x")
            self.writer.on_message_received(message)
            self.frames += 1
        if time.monotonic() >= self.saved + SAVED_EVERY:
            self.save()

    def save(self) -> None:
        """Hand over what was written to the operating system, which outlives this process."""
        self.saved = time.monotonic()
        if self.writer is None:
            return
        with self.whole():
            if isinstance(self.writer, can.BLFWriter):
                self.writer._flush()  # else it holds frames back until 128 KiB have come together
            self.writer.file.flush()

    def close(self) -> None:
        """Complete the file. **Raises** `CanLogError` where that cannot be done."""
        if self.writer is not None:
            with self.whole():
                self.writer.stop()
            self.writer = None

    @contextmanager
    def whole(self) -> Iterator[None]:
        """Lets go of the file where the disk fails, and says what to do."""
        try:
            yield
        except FileExistsError:
            raise
        except OSError as fault:
            writer, self.writer = self.writer, None
            if writer is not None:
                with suppress(OSError):  # it tries once more to write what it holds
                    writer.file.close()
            raise CanLogError(
                f"{self.path}: {fault.strerror or fault} after {self.frames} frames. What was "
                "written until then is kept. Make room, or name another disk, and record on in a "
                "new file."
            ) from fault


class Unkept:
    """In the place of a log where none was asked for."""

    frames = 0
    replace = False
    path = Path()

    def write(self, message: can.Message) -> None:
        """A frame is heard and forgotten."""

    def save(self) -> None:
        """There is nothing to keep."""

    def close(self) -> None:
        """There is nothing to complete."""


def begin(path: Path, mode: str) -> Any:
    """python-can's writer of a new file."""
    kind = path.suffix.lower()
    if kind == ".blf":
        file: Any = path.open(f"{mode}b")
        return can.BLFWriter(file)
    file = path.open(mode, encoding="utf-8", newline="\n")
    return can.ASCWriter(file) if kind == ".asc" else can.CanutilsLogWriter(file, "can0")
