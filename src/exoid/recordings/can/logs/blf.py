"""Reading BLF, the format exoid records in: all frames at once, by NumPy.

python-can reads a BLF frame by frame, six times slower, and gives up at the first damaged block.
A BLF is a header and blocks of zlib-compressed objects; a damaged block is left out and the rest
is read. The layout is that of python-can's `can.io.blf`, whose reader the tests compare with.
"""

import struct
from collections.abc import Iterator
from datetime import UTC, datetime
from pathlib import Path

import numpy as np

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
from exoid.recordings.can.logs.blf_blocks import (
    LONGEST_PADDING,
    OBJECT_HEADER,
    SIGNATURE,
    unbroken_pieces,
)

FILE_HEADER = struct.Struct("<4sL8B2Q2L8H8H")  # as python-can; the fields used are named below
VERSIONS = (1, 2)  # of an object's head
MESSAGE_TYPES = (1, 86)  # CAN_MESSAGE, CAN_MESSAGE2
ERROR_TYPE = 73  # CAN_ERROR_EXT
FD_TYPES = (100, 101)  # CAN_FD_MESSAGE, CAN_FD_MESSAGE_64
EXTENDED_BIT = 0x80000000
REMOTE_BIT = 0x80
TEN_MICROSECONDS = 1  # the object flag for times in 10 us instead of 1 ns
LONGEST_READ = 64  # bytes of an object that are looked at


def read_blf(path: Path) -> Log:
    """The frames of a BLF file.

    **Raises** `CanLogError` when the file is not a BLF at all.
    """
    content = path.read_bytes()
    if len(content) < FILE_HEADER.size or content[:4] != b"LOGG":
        raise CanLogError(
            f"{path} is not a BLF file: it does not begin with LOGG. Export it again."
        )
    header = FILE_HEADER.unpack_from(content)
    header_size, announced, start = header[1], header[12], header[14:22]
    pieces, faults = unbroken_pieces(content, header_size)
    positions = [object_positions(piece) for piece in pieces]
    if not faults and (odd := sum(map(misfits, pieces, positions))):
        faults.append(f"{odd} object(s) in the blocks are damaged")
    positions = [within(piece, at) for piece, at in zip(pieces, positions, strict=True)]
    begin = start_time(start)
    first, *others = (frames_at(*pair, begin) for pair in zip(pieces, positions, strict=True))
    return Log(
        path,
        first.followed_by(*others),
        stopped="; ".join(faults) or None,
        announced=announced,
        found=sum(at.size for at in positions),
    )


def start_time(system_time: tuple[int, ...]) -> float:
    """When the log began [s], from Windows' year, month, weekday, day, ...; 0 where not written."""
    year, month, _, day, hour, minute, second, millisecond = system_time
    try:
        moment = datetime(year, month, day, hour, minute, second, millisecond * 1000, tzinfo=UTC)
    except ValueError:
        return 0.0
    return moment.timestamp()


def object_positions(stream: bytes):
    """Where the objects begin.

    Every signature is one, unless it stands inside another object: then the chain of sizes, from
    object to object, says which are.
    """
    words = np.frombuffer(stream, dtype="<u4", count=len(stream) // 4)
    at = np.flatnonzero(words == np.frombuffer(SIGNATURE, dtype="<u4")[0]) * 4
    at = at[at + OBJECT_HEADER.size <= len(stream)]
    slack = np.diff(at) - words[at // 4 + 2][:-1].astype(np.int64)
    if not ((slack >= 0) & (slack < 4)).all() or (at.size and at[0] > 0):
        at = np.array(list(walk(stream)), dtype=np.int64)
    return at


def ends_of(stream: bytes, at):
    """Where objects end, as they say."""
    sizes = gather(stream, at + 8, "<u4") if at.size else at
    return at + sizes.astype(np.int64)


def within(stream: bytes, at):
    """Those of the objects that are whole."""
    return at[ends_of(stream, at) <= len(stream)]


def misfits(stream: bytes, at) -> int:
    """How many objects end elsewhere than the next begins, or the stream ends, or have heads of a
    version that nobody knows.
    """
    gaps = np.append(at, len(stream)) - np.append(0, ends_of(stream, at))
    strange = ~is_known(stream, at) if at.size else np.zeros(0, bool)
    return int(((gaps < 0) | (gaps > LONGEST_PADDING)).sum() + strange.sum())


def is_known(stream: bytes, at):
    """Are the heads of these objects of a version that is known?"""
    return np.isin(gather(stream, at + 6, "<u2"), VERSIONS)


def walk(stream: bytes) -> Iterator[int]:
    at = stream.find(SIGNATURE)
    while at >= 0 and at + OBJECT_HEADER.size <= len(stream):
        yield at
        size = OBJECT_HEADER.unpack_from(stream, at)[3]
        at = stream.find(SIGNATURE, at + max(size, OBJECT_HEADER.size))


def gather(stream: bytes, at, kind: str):
    """The number of this kind at each of the positions."""
    size = np.dtype(kind).itemsize
    everything = np.frombuffer(stream, dtype=np.uint8)
    picked = np.lib.stride_tricks.sliding_window_view(everything, size)[at]
    return np.ascontiguousarray(picked).view(kind)[:, 0]


def frames_at(stream: bytes, at, start: float) -> Frames:
    """The objects that are frames, in their order."""
    padded = stream + bytes(LONGEST_READ)  # so that a short last object can be read like the rest
    kinds = gather(padded, at + 12, "<u4")
    frames = np.isin(kinds, (*MESSAGE_TYPES, ERROR_TYPE, *FD_TYPES)) & is_known(padded, at)
    at, kinds = at[frames], kinds[frames]
    ticks = gather(padded, at + 24, "<u8")
    unit = np.where(gather(padded, at + 16, "<u4") == TEN_MICROSECONDS, 1e-5, 1e-9)
    body = at + np.where(gather(padded, at + 6, "<u2") == 2, 40, 32)
    identifier, flags, length = frame_heads(padded, body, kinds)
    data = gather(padded, body + 8, "<u8").reshape(-1, 1).view(np.uint8).copy()
    data[np.arange(8) >= length[:, None]] = 0
    return Frames(start + ticks * unit, identifier & 0x1FFFFFFF, flags, length, data)


def frame_heads(stream: bytes, body, kinds):
    """Id, flags and length of each frame; of error and FD frames only that they are such."""
    error = kinds == ERROR_TYPE
    identifier = gather(stream, body + np.where(error, 16, 4), "<u4")
    message = np.isin(kinds, MESSAGE_TYPES)
    control = gather(stream, body + 2, "<u1")
    length = np.where(message, gather(stream, body + 3, "<u1"), 0).astype(np.uint8)
    flags = np.zeros(body.size, dtype=np.uint8)
    flags[(identifier & EXTENDED_BIT) > 0] |= EXTENDED
    flags[message & ((control & REMOTE_BIT) > 0)] |= REMOTE
    flags[message & (length > 8)] |= UNEVEN
    flags[error] |= ERROR
    flags[~message & ~error] |= FD
    return identifier, flags, np.minimum(length, 8)
