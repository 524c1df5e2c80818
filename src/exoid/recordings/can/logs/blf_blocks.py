"""The blocks of a BLF: unpacked as far as each is whole, and never to more than a log can hold.

A block is a head, and objects that zlib has compressed: their checksum stands at its end.
"""

import struct
import zlib

OBJECT_HEADER = struct.Struct("<4sHHLL")  # signature, header size, header version, size, type
CONTAINER_HEADER = 32  # bytes before a block's content, the object header included
PACKING = struct.Struct("<H6xL")  # behind a block's object header: method, size when unpacked
METHODS = (0, 2)  # as it is, and by zlib
CONTAINER = 10
SIGNATURE = b"LOBJ"
LONGEST_PADDING = 3  # bytes between two blocks
# What a file may unpack to [bytes]: more would be no log, whose frames shrink to a tenth at best.
MOST_UNPACKED, MOST_PER_BYTE = 1 << 26, 30


def unbroken_pieces(content: bytes, begin: int) -> tuple[list[bytes], list[str]]:
    """The content of all blocks, parted where one is missing, and what is wrong with the file."""
    pieces: list[list[bytes]] = [[]]
    faults: list[str] = []
    room, padding = MOST_UNPACKED + MOST_PER_BYTE * len(content), 0
    while (at := content.find(SIGNATURE, begin)) >= 0 and at + CONTAINER_HEADER <= len(content):
        if at > begin + padding:
            faults.append(f"{at - begin} unknown bytes at byte {begin}")
            pieces.append([])
        padding, (*_, size, kind) = LONGEST_PADDING, OBJECT_HEADER.unpack_from(content, at)
        begin = at + max(size, CONTAINER_HEADER)
        if begin > len(content):
            faults.append(f"the file ends inside the block at byte {at}")
        if kind != CONTAINER:
            continue
        try:
            pieces[-1].append(unpacked(content[at:begin], begin > len(content), room))
            room -= len(pieces[-1][-1])
        except (zlib.error, DamagedBlock) as fault:
            faults.append(f"the block at byte {at} is damaged and left out ({fault})")
            pieces.append([])
    if at < 0 and len(content) > begin + LONGEST_PADDING:
        faults.append(f"{len(content) - begin} unknown bytes at byte {begin}")
    return [b"".join(piece) for piece in pieces], faults


class DamagedBlock(ValueError):
    """A block that is not as long as it says, or whose checksum is not there."""


def unpacked(block: bytes, cut: bool, room: int) -> bytes:
    """The content of one block, never more than it declares; of one that was cut, what is there.

    zlib compares its checksum when it comes to it. A block that ends before was never compared.
    """
    method, declared = PACKING.unpack_from(block, OBJECT_HEADER.size)
    if declared > room:
        raise DamagedBlock(f"it declares {declared} bytes, more than such a file can hold")
    if method not in METHODS:
        raise DamagedBlock(f"it is packed in a way {method} that nobody knows")
    body, complete = block[CONTAINER_HEADER:], True
    if method:
        stream = zlib.decompressobj()
        body = stream.decompress(body, declared + 1)
        complete = stream.eof
    if len(body) > declared or (complete and not cut and len(body) < declared):
        raise DamagedBlock(f"it declares {declared} bytes and holds others")
    if not cut and not complete:
        raise DamagedBlock("its checksum is missing")
    return body
