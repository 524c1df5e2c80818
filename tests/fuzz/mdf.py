"""MF4 as mdfreader reads it, which shares no code with asammdf."""

from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import numpy as np

from exoid.recordings.can.frames import EXTENDED, FD, Frames
from exoid.recordings.can.logs.mf4 import IDENTIFIER, KEPT, KINDS

from .reading import Unread

BEGIN = 136  # bytes, where the header says when the log begins [ns]; asammdf rounds it to us


def frames_by_mdfreader(path: Path) -> Frames:
    """The CAN frames in order of time; where a clock was set back, the order of a group stays."""
    import mdfreader

    file: Any = mdfreader.Mdf(str(path))
    if any(len(names) < 2 for names in file.masterChannelList.values()):
        raise Unread("a group with nothing but its times: channels that it does not know are lost")
    begin = int.from_bytes(path.read_bytes()[BEGIN : BEGIN + 8], "little")
    begin = datetime.fromtimestamp(begin / 1e9, UTC).timestamp()
    parts = [frames_of(file, kind, begin) for kind in KINDS if f"{kind}.ID" in file]
    found = parts[0].followed_by(*parts[1:])
    key = np.concatenate([np.maximum.accumulate(each.time) for each in parts])
    return found.where(np.argsort(key, kind="stable"))


def frames_of(file: Any, kind: str, begin: float) -> Frames:
    def column(name: str) -> np.ndarray:
        return file.get_channel_data(f"{kind}.{name}")

    time = file.get_channel_data(file.get_channel_master(f"{kind}.ID")) + begin
    flags = np.where(column("IDE") > 0, EXTENDED, 0) | KINDS[kind]
    none = np.zeros(time.size, np.uint32)
    data, length = np.zeros((time.size, KEPT), np.uint8), none
    if kind == "CAN_DataFrame":
        flags |= np.where(column("EDL") > 0, FD, 0)
        length = column("DataLength")
        data = np.array([[*bytes(each)[:KEPT].ljust(KEPT, b"\0")] for each in column("DataBytes")])
        data[np.arange(KEPT) >= length[:, None]] = 0
    identifier = (column("ID") & IDENTIFIER).astype(np.uint32)
    return Frames(time, identifier, flags.astype(np.uint8), length.astype(np.uint8),
                  data.astype(np.uint8))  # fmt: skip
