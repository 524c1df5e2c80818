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

from exoid.files.counted import counted
from exoid.recordings.can.frames import CanLogError, Log
from exoid.recordings.can.logs.blf_blocks import (
    LONGEST_PADDING,
    OBJECT_HEADER,
    SIGNATURE,
    unbroken_pieces,
)
from exoid.recordings.can.logs.blf_objects import frames_at, gather, is_known

FILE_HEADER = struct.Struct("<4sL8B2Q2L8H8H")  # as python-can; the fields used are named below


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
        faults.append(f"{counted(odd, 'damaged object')} in the blocks")
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

    Every signature in a whole word is one, unless it stands inside another object, or objects have
    odd lengths: then the chain of sizes, from object to object, says which are.
    """
    words = np.frombuffer(stream, dtype="<u4", count=len(stream) // 4)
    at = np.flatnonzero(words == np.frombuffer(SIGNATURE, dtype="<u4")[0]) * 4
    at = at[at + OBJECT_HEADER.size <= len(stream)]
    slack = np.diff(np.append(at, len(stream))) - words[at // 4 + 2].astype(np.int64)
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


def walk(stream: bytes) -> Iterator[int]:
    at = stream.find(SIGNATURE)
    while at >= 0 and at + OBJECT_HEADER.size <= len(stream):
        yield at
        size = OBJECT_HEADER.unpack_from(stream, at)[3]
        at = stream.find(SIGNATURE, at + max(size, OBJECT_HEADER.size))
