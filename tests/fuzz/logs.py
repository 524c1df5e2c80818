"""CAN logs: exoid's readers, and python-can's beside them."""

import io
import re
from itertools import islice
from pathlib import Path
from tempfile import TemporaryDirectory

import can
import numpy as np
from can.io.player import MESSAGE_READERS
from tests.recordings.exo_node import EPOCH, Node, write_log

from exoid.recordings.can.frames import ERROR, FD, REMOTE, UNEVEN, Log
from exoid.recordings.can.logs.log_files import frames_of, read_log, row_of
from exoid.recordings.loading.can_log import read_can_log

from .draw import log, text
from .inside import in_blf
from .mdf import frames_by_mdfreader
from .reading import Format, Reading, Rows, Sample

TICKS = 5
MOST = 10_000  # frames; python-can's readers may go on for ever


def messages(odd: bool) -> list[can.Message]:
    """A node's frames; with `odd`, frames of other kinds among them."""
    found = Node().messages(TICKS)
    if odd:
        kinds = [
            can.Message(arbitration_id=0x18EBFF00, data=b"\1\2\3"),
            can.Message(arbitration_id=0x123, is_extended_id=False, is_remote_frame=True, dlc=4),
            can.Message(is_error_frame=True),
            can.Message(arbitration_id=0x321, is_extended_id=False, data=b""),
        ]
        for number, each in enumerate(kinds):
            each.timestamp = EPOCH + 1 + number / 100
        found += kinds
    return found


def log_samples(suffix: str) -> tuple[Sample, ...]:
    with TemporaryDirectory() as folder:
        path = Path(folder) / f"log{suffix}"
        return tuple(
            Sample(undated(write_log(path, messages(odd)).read_bytes(), folder))
            for odd in (False, True)
        )


def undated(content: bytes, folder: str) -> bytes:
    """Without the place and, in ASC, the time at which it was written."""
    return re.sub(
        rb"^date .*", b"date Sam Sep 30 15:06:13.191 2017", content.replace(folder.encode(), b"/")
    )


def read_frames(path: Path) -> Reading:
    """The frames; every sixteenth file is read as a recording, too, which has more to check."""
    log = read_log(path)
    if sum(path.read_bytes()[-4:]) % 16 == 0:
        read_can_log(path)
    return Reading(columns(log), said(log))


def columns(log: Log) -> Rows:
    """Without the length of what is no plain frame, which exoid does not read."""
    odd = log.frames.flags & (ERROR | FD | REMOTE) > 0
    return vars(log.frames) | {
        "flags": np.where(odd, log.frames.flags & ~np.uint8(UNEVEN), log.frames.flags),
        "length": np.where(odd, 0, log.frames.length),
        "data": np.where(odd[:, None], 0, log.frames.data),
    }


def said(log: Log) -> tuple[str, ...]:
    missing = log.announced is not None and log.announced != log.found
    return tuple(filter(None, (log.stopped, "another count is announced" if missing else "")))


def frames_by_python_can(path: Path, _sample: Sample) -> Rows:
    """All frames that python-can reads. **Raises** what it raises."""
    with reader_of(path) as reader:
        found = frames_of([row_of(each) for each in islice(reader, MOST)])
    return columns(Log(path, found))


def rows_by_mdfreader(path: Path, _sample: Sample) -> Rows:
    return columns(Log(path, frames_by_mdfreader(path)))


def reader_of(path: Path):
    """Bytes that are no text are replaced in a log of text, as exoid replaces them."""
    kind = MESSAGE_READERS[path.suffix]
    if path.suffix == ".blf":
        return kind(path)
    text = path.read_text(encoding="utf-8", errors="replace")
    # Its reader of ASC takes the first line below the header for the end of it, were it a frame.
    return kind(io.StringIO("\n" + text if path.suffix == ".asc" else text))  # pyright: ignore[reportArgumentType]


def log_formats() -> dict[str, Format]:
    """By the names under which they are counted."""
    found = {
        suffix[1:]: Format(
            suffix, log_samples(suffix), read_frames, frames_by_python_can, drawn=text
        )
        for suffix in (".asc", ".log", ".trc", ".csv")
    }
    mf4 = Format(".mf4", log_samples(".mf4"), read_frames, rows_by_mdfreader, stricter=True)
    blf = Format(".blf", log_samples(".blf"), read_frames, frames_by_python_can, in_blf, log)
    return {"can " + name: each for name, each in {"blf": blf, **found, "mf4": mf4}.items()}
