"""Whether structs and cells in a .mat of version 5 to 7 hold as many parts as they announce.

SciPy reads as many fields as their names make, and says nothing of what is left over. An element is
a tag of kind and size, and its content up to a multiple of 8 bytes; a matrix is one of elements.
"""

import struct
import zlib
from collections.abc import Iterator

import numpy as np

ORDERS = {b"IM": "<", b"MI": ">"}  # how the two bytes before the first element say it
HEAD = 128  # bytes
SMALL = 4  # bytes of an element within its tag
MATRIX, PACKED = 14, 15
CELL, STRUCT = 1, 2


def check_parts(content: bytes) -> None:
    """**Raises** `ValueError` where a struct or cell array has lost a part."""
    order = ORDERS.get(content[HEAD - 2 : HEAD])
    if order is None:
        return  # of version 4, which has neither
    for kind, inner in elements(order, content[HEAD:]):
        if kind == PACKED:
            kind, inner = next(elements(order, zlib.decompress(inner)), (0, b""))
        if kind == MATRIX:
            check_matrix(order, inner)


def elements(order: str, content: bytes) -> Iterator[tuple[int, bytes]]:
    """Kinds and contents; the last may be cut."""
    at = 0
    while at + 8 <= len(content):
        kind, size = struct.unpack_from(f"{order}LL", content, at)
        if kind >> 16:
            yield kind & 0xFFFF, content[at + SMALL : at + SMALL + (kind >> 16)]
            at += 8
        else:
            yield kind, content[at + 8 : at + 8 + size]
            at += 8 + size + (0 if kind == PACKED else -size % 8)


def check_matrix(order: str, content: bytes) -> None:
    parts = [inner for _, inner in elements(order, content)]
    if len(parts) < 3:
        return  # an empty one
    kind = integers(order, parts[0])[0] & 0xFF
    if kind not in (CELL, STRUCT):
        return
    count, below = int(np.prod(integers(order, parts[1]).astype(float))), parts[3:]
    if kind == STRUCT:
        (length, *_), names, below = integers(order, parts[3]), parts[4], parts[5:]
        if length <= 0 or len(names) % length:
            raise ValueError("the fields of a struct are not named as MATLAB names them")
        count *= len(names) // int(length)
    if len(below) != count:
        raise ValueError(f"a struct or cell array announces {count} parts and holds {len(below)}")
    for each in below:
        check_matrix(order, each)


def integers(order: str, content: bytes) -> np.ndarray:
    return np.frombuffer(content, f"{order}i4")
