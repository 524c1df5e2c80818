"""The CAN frames of an MF4 file as columns; asammdf parses the file."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from exoid.files.foreign import Arrays
from exoid.files.library_faults import is_ours, plain
from exoid.recordings.can.frames import ERROR, EXTENDED, FD, REMOTE, Frames

KINDS = {"CAN_DataFrame": 0, "CAN_ErrorFrame": ERROR, "CAN_RemoteFrame": REMOTE}
OTHERS = {"CAN_OverloadFrame"}  # what else a bus says, and no log is read for
NEEDED = {
    "CAN_DataFrame": ("ID", "DataLength", "DataBytes"),
    "CAN_RemoteFrame": ("ID",),
    "CAN_ErrorFrame": (),
}  # without which a record is no frame
INTEGERS = (".ID", ".IDE", ".DataLength", ".EDL")
LAST_INTEGER = 3  # of MDF's types of data: unsigned and signed, of either byte order
CHUNK = 100_000  # frames; more at once take longer, and as much more memory
IDENTIFIER = 0x1FFFFFFF  # the bits that an id may have
KEPT = 8  # bytes of a frame, as of the other formats


def read_frames(path: Path) -> Arrays:
    """The columns of `Frames`, in order of time, and why what follows them was not read."""
    parts, keys, stopped = [], [np.zeros(0)], ""
    try:
        for part, key in parts_of(path):
            parts.append(part)
            keys.append(key)
    except Exception as fault:  # asammdf has no family of them: a bad file raises anything
        stopped = plain(str(fault)) if is_ours(fault) else "a block of the file is damaged"
    none = frames_of(np.zeros(0), "", np.zeros(0))
    found = none.followed_by(*parts).where(np.argsort(np.concatenate(keys), kind="stable"))
    return vars(found) | {"stopped": np.array(stopped)}


def parts_of(path: Path) -> Iterator[tuple[Frames, np.ndarray]]:
    """Frames of one group after the other, each with the time by which groups are merged.

    Where the clock of a group was set back, that is the latest time before: its order stays.
    """
    from asammdf import MDF

    file: Any = MDF(path)
    begin = file.header.start_time.timestamp()
    for number, group in enumerate(file.groups):
        kind = kind_of(group)
        size = group.channel_group.samples_byte_nr
        if kind and any(is_outside(each, size) for each in group.channels):
            raise ValueError("a channel of the file lies outside of its records")
        if kind and any(map(is_no_integer, group.channels)):
            raise ValueError("a channel of the file is no integer, as it should be")
        if kind and number not in file.masters_db:
            raise ValueError("a group of CAN frames has no times")  # asammdf would count them
        latest, announced = -np.inf, group.channel_group.cycles_nr if kind else 0
        for at in range(0, announced, CHUNK):
            found = file.get(kind, number, raw=False, record_offset=at, record_count=CHUNK)
            if found.timestamps.size < min(CHUNK, announced - at):
                raise ValueError("a group of the file holds fewer frames than it announces")
            frames = frames_of(found.timestamps + begin, kind, found.samples)
            key = np.maximum.accumulate(np.r_[latest, frames.time])
            latest = key[-1]
            yield frames, key[1:]


def is_outside(channel: Any, size: int) -> bool:
    """Would asammdf read a channel from beyond its byte, or its record [bytes]?"""
    end = 8 * channel.byte_offset + channel.bit_offset + channel.bit_count
    return channel.bit_offset >= 8 or end > 8 * size


def is_no_integer(channel: Any) -> bool:
    """Would asammdf make a number of what is said to be text or a date?"""
    return channel.name.endswith(INTEGERS) and channel.data_type > LAST_INTEGER


def kind_of(group: Any) -> str:
    """The channel of a group that holds CAN frames, or nothing.

    **Raises** `ValueError` where a group half looks like one: its frames would be missed.
    """
    from asammdf import Source
    from asammdf.blocks.v4_constants import FLAG_CG_BUS_EVENT

    source, events = group.channel_group.acq_source, group.channel_group.flags & FLAG_CG_BUS_EVENT
    names = {each.name for each in group.channels}
    kind = next((each for each in KINDS if each in names), "")
    on_can = events and source is not None and source.bus_type == Source.BUS_TYPE_CAN
    if on_can and ("" in names or not (kind or names & OTHERS)):
        raise ValueError("a group of CAN frames has a channel without its name")
    if kind and not on_can:
        raise ValueError("a group of CAN frames is not marked as one")
    return kind


def frames_of(time: np.ndarray, kind: str, samples: np.ndarray) -> Frames:
    """Records of one kind as frames; what a device does not write has its usual value."""

    def column(name: str, usual: np.ndarray) -> np.ndarray:
        field = f"{kind}.{name}"
        return samples[field] if field in (samples.dtype.names or ()) else usual

    for name in NEEDED.get(kind, ()):
        if f"{kind}.{name}" not in (samples.dtype.names or ()):
            raise ValueError(f"its frames have no {name}")
    none, one = np.zeros(time.size, np.uint32), np.ones(time.size, np.uint32)
    content = column("DataBytes", np.zeros((time.size, 0), np.uint8))
    length = np.clip(column("DataLength", none), 0, content.shape[1])
    data = np.zeros((time.size, KEPT), np.uint8)
    data[:, : content.shape[1]] = content[:, :KEPT]
    data[np.arange(KEPT) >= length[:, None]] = 0
    flags = np.where(column("IDE", one) > 0, EXTENDED, 0) | KINDS.get(kind, 0)
    if kind == "CAN_DataFrame":
        flags |= np.where(column("EDL", none) > 0, FD, 0)
    identifier = (column("ID", none) & IDENTIFIER).astype(np.uint32)
    return Frames(time, identifier, flags.astype(np.uint8), length.astype(np.uint8), data)
