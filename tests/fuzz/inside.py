"""Damage inside of what is packed: the checksum is right again, and only the reader can notice."""

import random
import struct
import zlib
from collections.abc import Sequence
from io import BytesIO
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

from .mutate import mutated

BLF_HEAD = 144  # bytes of a BLF's own header
BLOCK_HEAD = 32
MAT_HEAD = 128


def in_zip(draw: random.Random, content: bytes, _others: Sequence[bytes]) -> bytes:
    """One of the files in an archive."""
    with ZipFile(BytesIO(content)) as archive:
        files = {each.filename: archive.read(each) for each in archive.infolist()}
    name = draw.choice(sorted(files))
    return zipped(files | {name: mutated(draw, files[name], [*files.values()])})


def zipped(files: dict[str, bytes]) -> bytes:
    """An archive of one date, so that the same files are the same bytes."""
    packed = BytesIO()
    with ZipFile(packed, "w", ZIP_DEFLATED) as archive:
        for name, each in files.items():
            archive.writestr(ZipInfo(name), each, ZIP_DEFLATED)
    return packed.getvalue()


def repacked(content: bytes) -> bytes:
    """An archive without the times at which it was made."""
    with ZipFile(BytesIO(content)) as archive:
        return zipped({each.filename: archive.read(each) for each in archive.infolist()})


def in_blf(draw: random.Random, content: bytes, _others: Sequence[bytes]) -> bytes:
    """The objects in the first block of a BLF."""
    size = struct.unpack_from("<L", content, BLF_HEAD + 8)[0]
    begin, end = BLF_HEAD + BLOCK_HEAD, BLF_HEAD + size
    objects = zlib.decompress(content[begin:end])
    damaged = mutated(draw, objects, [objects])
    body = zlib.compress(damaged, 1)
    head = bytearray(content[BLF_HEAD:begin])
    struct.pack_into("<L", head, 8, BLOCK_HEAD + len(body))
    struct.pack_into("<L", head, 24, len(damaged))
    new = bytes(head) + body
    return content[:BLF_HEAD] + new + bytes(len(new) % 4) + content[end + size % 4 :]


def in_mat(draw: random.Random, content: bytes, _others: Sequence[bytes]) -> bytes:
    """The first variable of a compressed .mat."""
    kind, size = struct.unpack_from("<LL", content, MAT_HEAD)
    begin, end = MAT_HEAD + 8, MAT_HEAD + 8 + size
    if kind != 15:  # not a compressed one
        return mutated(draw, content, [content])
    inner = zlib.decompress(content[begin:end])
    body = zlib.compress(mutated(draw, inner, [inner]), 1)
    return content[:MAT_HEAD] + struct.pack("<LL", 15, len(body)) + body + content[end:]
