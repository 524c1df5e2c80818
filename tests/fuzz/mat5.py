"""A .mat of version 5 to 7 from its bytes: a second hand, since no other maintained reader is one.

Elements are a tag of two words, kind and size, and their content up to a multiple of 8 bytes; a
small one has both in one word. A matrix is an element of elements: flags, sizes, name, values.
"""

import struct
import zlib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from exoid.recordings.formats.matlab import HDF5, USER_BLOCK
from exoid.recordings.tables.arrays import sheet_of_arrays
from exoid.recordings.tables.sheet import Place

from .hdf5 import variables_by_pyfive
from .reading import Rows, Sample, Unread
from .tables import numbers_of

HEAD = 128  # bytes of text, version and order
MATRIX, PACKED = 14, 15
STORED = {1: "i1", 2: "u1", 3: "i2", 4: "u2", 5: "i4", 6: "u4", 7: "f4", 9: "f8", 12: "i8",
          13: "u8"}  # fmt: skip
KINDS = {6: "f8", 7: "f4", 8: "i1", 9: "u1", 10: "i2", 11: "u2", 12: "i4", 13: "u4", 14: "i8",
         15: "u8"}  # fmt: skip
STRUCT, COMPLEX, TRUTH = 2, 0x800, 0x200
Element = tuple[int, bytes]


def variables_by_hand(path: Path, _sample: Sample) -> Rows:
    """The variables of any .mat."""
    content = path.read_bytes()
    if content[USER_BLOCK:].startswith(HDF5) or content.startswith(HDF5):
        return variables_by_pyfive(path)
    order = {b"IM": "<", b"MI": ">"}[content[126:128]]
    found = dict(matrix(order, each) for each in matrices(order, content[HEAD:]))
    return numbers_of(sheet_of_arrays(found, Place("sample")))


def matrices(order: str, content: bytes) -> Iterator[bytes]:
    for kind, inner in elements(order, content):
        whole = [*elements(order, zlib.decompress(inner))] if kind == PACKED else [(kind, inner)]
        for kind, inner in whole:
            if kind != MATRIX:
                raise Unread(f"a variable of kind {kind}")
            yield inner


def elements(order: str, content: bytes) -> Iterator[Element]:
    at = 0
    while at < len(content):
        kind, size = struct.unpack_from(order + "LL", content, at)
        begin = at + 8
        if kind >> 16:
            kind, size, begin = kind & 0xFFFF, kind >> 16, at + 4
        inner = content[begin : begin + size]
        if len(inner) < size:
            raise ValueError("an element is cut")
        yield kind, inner
        at = at + 8 if begin == at + 4 else begin + size + (0 if kind == PACKED else -size % 8)


def matrix(order: str, content: bytes) -> tuple[str, Any]:
    """Its name and its values, without axes of length 1."""
    parts = elements(order, content)
    (flags, _), sizes, name = (numbers(order, next(parts)) for _ in range(3))
    shape, kind = tuple(sizes.tolist()), flags & 0xFF
    word = name.tobytes().decode("latin1")
    if kind == STRUCT and np.prod(shape) == 1:
        return word, fields(order, parts)
    if kind not in KINDS or flags & (COMPLEX | TRUTH):
        raise Unread(f"a matrix of kind {kind}")
    values = numbers(order, next(parts))
    if values.dtype.kind != "f":  # SciPy keeps doubles that are said to be singles
        values = values.astype(KINDS[kind])
    return word, np.squeeze(values.reshape(shape, order="F"))


def fields(order: str, parts: Iterator[Element]) -> dict[str, Any]:
    """A struct's."""
    length = int(numbers(order, next(parts))[0])
    names = next(parts)[1]
    words = [names[at : at + length].split(b"\0")[0].decode("latin1")
             for at in range(0, len(names), length)]  # fmt: skip
    return {word: matrix(order, inner)[1] for word, (_, inner) in zip(words, parts, strict=True)}


def numbers(order: str, element: Element) -> np.ndarray:
    kind, content = element
    return np.frombuffer(content, order + STORED[kind])
