"""What a C3D file says twice: its header of 512 bytes, and its parameters.

No checksum covers a C3D file. Where the two differ, one of them is damaged, and samples may be read
from the wrong place.
"""

import struct
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

BLOCK = 512  # bytes
BIG_ENDIAN, DEC = 86, 85  # kinds of processors; Intel's is 84
MOST_FRAMES = 65535  # that a header can count


@dataclass(frozen=True)
class Header:
    """The words of a header that the parameters repeat."""

    points: int
    analogs: int  # samples in a frame, of all channels
    first: int  # frame
    last: int
    start: int  # block, counted from 1
    scale: float  # below 0: samples are floats
    rate: float  # Hz; NaN where it is written as DEC did


def header_of(content: bytes) -> Header:
    """The header of what the file begins with, the parameters too.

    **Raises** `ValueError` where it has none.
    """
    place = (content[0] - 1) * BLOCK if content else 0
    if len(content) < BLOCK or not BLOCK <= place + 4 <= len(content):
        raise ValueError("has no header and parameters of a C3D file. Export it again.")
    processor = content[place + 3]
    order = ">" if processor == BIG_ENDIAN else "<"
    points, analogs, first, last, _ = struct.unpack_from(f"{order}5H", content, 2)
    scale, start, _, rate = struct.unpack_from(f"{order}fHHf", content, 12)
    if processor == DEC:
        scale, rate = float("nan"), float("nan")
    return Header(points, analogs, first, last, start, scale, rate)


def differences(header: Header, told: Mapping[str, float], frames: int, size: int) -> Iterator[str]:
    """What the header says otherwise than the `frames` that were read of `size` bytes, and than the
    parameters that were `told`.
    """
    width = 2 if header.scale > 0 else 4
    end = (header.start - 1) * BLOCK + width * frames * (4 * header.points + header.analogs)
    if size < end:
        yield f"it ends {end - size} bytes before its last sample."
    announced = header.last - header.first + 1
    counted = header.last < MOST_FRAMES
    if counted and announced != frames:
        yield f"its header announces {announced} frames, and it holds {frames}."
    pairs = {
        "frames": (announced, told["frames"] if counted else float("nan")),
        "points": (header.points, told["points"]),
        "analog samples a frame": (header.analogs, told["analogs"]),
        "as the block of the first sample": (header.start, told["start"]),
        "Hz": (header.rate, told["rate"]),
        "as the scale": (header.scale, told["scale"]),
    }
    for what, (one, other) in pairs.items():
        if differ(one, other):
            yield f"its header announces {one:g} {what}, its parameters {other:g}."


def differ(one: float, other: float) -> bool:
    """NaN is what one of them does not say."""
    return abs(one - other) > 1e-6 * abs(other)
