"""The objects of a BLF that are frames, as columns."""

from dataclasses import dataclass

import numpy as np

from exoid.recordings.can.frames import ERROR, EXTENDED, FD, REMOTE, UNEVEN, Frames

VERSIONS = (1, 2)  # of an object's head
EXTENDED_BIT = 0x80000000
TEN_MICROSECONDS = 1  # the object flag for times in 10 us instead of 1 ns
LONGEST_READ = 96  # bytes of an object that are looked at
LENGTHS = np.array([*range(9), 12, 16, 20, 24, 32, 48, 64], np.uint8)  # by its code, on FD channels
ERROR_TYPE, ERROR_IDENTIFIER = 73, 16  # CAN_ERROR_EXT, and where its identifier is


@dataclass(frozen=True)
class Layout:
    """Where a frame's object has what: bytes behind its head. A flag is a byte and a bit of it."""

    code: int  # of the length
    valid: int  # how many bytes of data there are
    remote: tuple[int, int]
    data: int
    fd: tuple[int, int] | None = None  # None: on a channel that knows no FD
    cut: int | None = None  # where in the object the data end, 0 for at its own end


IDENTIFIER = 4
LAYOUTS = {
    1: Layout(3, 3, (2, 0x80), 8),  # CAN_MESSAGE
    86: Layout(3, 3, (2, 0x80), 8),  # CAN_MESSAGE2
    100: Layout(3, 14, (2, 0x80), 20, (13, 0x01)),  # CAN_FD_MESSAGE
    101: Layout(1, 2, (12, 0x10), 40, (13, 0x10), 35),  # CAN_FD_MESSAGE_64
}


def frames_at(stream: bytes, at, start: float) -> Frames:
    """The objects that are frames, in their order. Of error and FD frames only that they are such;
    an FD channel's objects may hold plain frames, too.
    """
    padded = stream + bytes(LONGEST_READ)  # so that a short last object can be read like the rest
    kinds = gather(padded, at + 12, "<u4")
    frames = np.isin(kinds, (*LAYOUTS, ERROR_TYPE)) & is_known(padded, at)
    at, kinds = at[frames], kinds[frames]
    ticks = gather(padded, at + 24, "<u8")
    unit = np.where(gather(padded, at + 16, "<u4") == TEN_MICROSECONDS, 1e-5, 1e-9)
    body = at + np.where(gather(padded, at + 6, "<u2") == 2, 40, 32)
    error = kinds == ERROR_TYPE
    identifier = gather(padded, body + np.where(error, ERROR_IDENTIFIER, IDENTIFIER), "<u4")
    flags = np.where(identifier & EXTENDED_BIT, EXTENDED, 0).astype(np.uint8)
    flags[error] |= ERROR
    length, data = np.zeros(at.size, np.uint8), np.zeros((at.size, 8), np.uint8)
    for kind, layout in LAYOUTS.items():
        rows = kinds == kind
        said, length[rows], data[rows] = contents(padded, at[rows], body[rows], layout)
        flags[rows] |= said
    return Frames(start + ticks * unit, identifier & 0x1FFFFFFF, flags, length, data)


def contents(stream: bytes, at, body, layout: Layout):
    """Flags, lengths and data of the objects of one layout."""
    code, valid = (gather(stream, body + where, "<u1") for where in (layout.code, layout.valid))
    flags = np.where(is_set(stream, body, layout.remote), REMOTE, 0).astype(np.uint8)
    if layout.fd is None:
        flags[code > 8] |= UNEVEN
        length = np.minimum(valid, 8)
    else:
        fd = is_set(stream, body, layout.fd)
        flags[fd] |= FD
        flags[~fd & (LENGTHS[np.minimum(code, 15)] != valid)] |= UNEVEN
        length = np.where(fd, 0, valid)
    data = gather(stream, body + layout.data, "<u8").reshape(-1, 1).view(np.uint8).copy()
    held = np.minimum(length, room(stream, at, body, layout))
    data[np.arange(8) >= held[:, None]] = 0
    return flags, length, data


def room(stream: bytes, at, body, layout: Layout):
    """How many bytes of data are in the objects; what lacks is zeros, as for Vector's library."""
    if layout.cut is None:
        return 8
    head = gather(stream, at + 4, "<u2").astype(np.int64)
    ends = gather(stream, body + layout.cut, "<u1").astype(np.int64)
    size = gather(stream, at + 8, "<u4").astype(np.int64)
    return np.maximum(np.where(ends > 0, ends, size) - head - layout.data, 0)


def is_set(stream: bytes, body, flag: tuple[int, int]):
    where, bit = flag
    return gather(stream, body + where, "<u1") & bit > 0


def is_known(stream: bytes, at):
    """Are the heads of these objects of a version that is known?"""
    return np.isin(gather(stream, at + 6, "<u2"), VERSIONS)


def gather(stream: bytes, at, kind: str):
    """The number of this kind at each of the positions."""
    size = np.dtype(kind).itemsize
    everything = np.frombuffer(stream, dtype=np.uint8)
    picked = np.lib.stride_tricks.sliding_window_view(everything, size)[at]
    return np.ascontiguousarray(picked).view(kind)[:, 0]
