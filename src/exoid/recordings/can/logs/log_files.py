"""Reading a log file, whatever its format.

BLF is read by blf.py and MF4 by mf4.py; every other format by the reader of python-can, whose
faults end here.
"""

import warnings
from collections.abc import Iterable
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np

from exoid.files.extras import installing
from exoid.files.foreign import ForeignError, read_apart
from exoid.files.library_faults import is_ours, plain, quiet
from exoid.recordings.can.frames import (
    ERROR,
    EXTENDED,
    FD,
    REMOTE,
    UNEVEN,
    CanLogError,
    Frames,
    Log,
)
from exoid.recordings.can.logs.blf import read_blf
from exoid.recordings.can.logs.mf4 import read_frames
from exoid.recordings.can.logs.text.asc import base_of
from exoid.recordings.can.logs.text.lines import Lines, told
from exoid.recordings.can.logs.text.own_csv import HEADER

Row = tuple[float, int, int, int, bytes]  # time, id, flags, length, data of one frame

FORMATS = (".blf", ".mf4", ".asc", ".csv", ".log", ".trc")
MARKERS = "PathFileType"  # begins a .trc of motion capture
SKIP_FIRST = (".asc", ".csv", ".log")  # what these readers lose when they begin again: a line


def read_log(path: Path) -> Log:
    """All frames of a log file that can be read.

    **Raises** `CanLogError` when there are none, and `OSError` when the file cannot be opened.
    """
    kind = path.suffix.lower()
    if kind not in FORMATS and path.exists():
        raise CanLogError(
            f"{path}: a recording is a table (.csv .txt .xlsx .parquet .mat .npz .mot .sto .c3d) "
            f"or a CAN log ({', '.join(FORMATS)}). Save or export it as one of these."
        )
    if path.stat().st_size == 0:
        raise CanLogError(f"{path} is empty. Was the logger stopped before it wrote anything?")
    readers = {".blf": read_blf, ".mf4": read_mf4}
    log = readers[kind](path) if kind in readers else read_text(path, kind)
    if not len(log.frames):
        reason = log.stopped or "its reader found no frame in it"
        raise CanLogError(
            f"{path} holds no CAN frame that can be read: {reason}. "
            "Record it again, or export it again from the tool that made it."
        )
    return log


def read_mf4(path: Path) -> Log:
    """The frames of an MF4 file, which asammdf parses in a process of its own."""
    if find_spec("asammdf") is None:
        raise CanLogError(f"{path}: MF4 needs asammdf: {installing('mf4')}")
    try:
        columns = read_apart(
            read_frames, path, "Export it again, as MF4 or as BLF.", library="asammdf"
        )
    except ForeignError as fault:
        raise CanLogError(str(fault)) from fault
    stopped = str(columns.pop("stopped")) or None
    return Log(path, Frames(**columns), stopped)


def read_text(path: Path, kind: str) -> Log:
    """The frames of a text log; a line that cannot be read is left out."""
    from can.io.player import MESSAGE_READERS

    lines = Lines(path, kind)
    if kind == ".csv" and lines.first != HEADER:
        raise CanLogError(
            f"{path}: line 1 is {plain(lines.first[:60])}, not the header of python-can's CSV "
            f"({HEADER}). Export the log as BLF, ASC or candump."
        )
    if kind == ".trc" and lines.first.startswith(MARKERS):
        raise CanLogError(
            f"{path}: this .trc holds the places of markers, and no angle of the knee. Export the "
            "angle from the model that was fitted to them: a .mot of inverse kinematics, or a C3D "
            "with model angles."
        )
    base = {"base": base_of(lines.lines)} if kind == ".asc" else {}
    reader: Any = MESSAGE_READERS[kind](lines, **base)  # pyright: ignore[reportArgumentType]
    rows: list[Row] = []
    with quiet("can"):
        while (fault := collect(reader, rows)) and lines.leave_out(fault):
            lines.blank_first = kind in SKIP_FIRST
    return Log(path, frames_of(rows), told(lines.damaged, lines.cut))


def collect(reader: Iterable[Any], rows: list[Row]) -> str | None:
    """Take frames from a reader until its end, or until it fails: then why."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # the readers' own, which say nothing about the file
        try:
            for message in reader:
                rows.append(row_of(message))
        except Exception as fault:
            # python-can's readers have no family of exceptions: a bad file raises anything.
            return plain(str(fault)) if is_ours(fault) else "no frame of this format"
    return None


def row_of(message: Any) -> Row:
    data = bytes(message.data)
    return (
        message.timestamp,
        message.arbitration_id & 0xFFFFFFFF,
        flags_of(message),
        min(len(data), 255),
        data[:8].ljust(8, b"\0"),
    )


def frames_of(rows: list[Row]) -> Frames:
    time, identifier, flags, length, data = zip(*rows, strict=True) if rows else ((),) * 5
    return Frames(
        np.array(time, dtype=np.float64),
        np.array(identifier, dtype=np.uint32),
        np.array(flags, dtype=np.uint8),
        np.array(length, dtype=np.uint8),
        np.frombuffer(b"".join(data), dtype=np.uint8).reshape(-1, 8),
    )


def flags_of(message: Any) -> int:
    flags = EXTENDED if message.is_extended_id else 0
    if message.is_remote_frame:
        return flags | REMOTE
    if message.is_error_frame:
        return flags | ERROR
    if message.is_fd:
        flags |= FD
    return flags | (UNEVEN if message.dlc != len(message.data) else 0)
