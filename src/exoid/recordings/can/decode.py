"""How the bits of a CAN frame become numbers, for all frames of a log at once.

The layout comes from a DBC file; what cantools says of one frame, this says of millions.
"""

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float, Shaped, UInt8

FrameData = UInt8[np.ndarray, "frame 8"]  # a shorter frame is padded with zeros

WORD = 64  # bits of a classic CAN frame
BLOCK = 8192  # frames decoded at a time: source and result together stay in the processor's cache
NATIVE_LENGTHS = (8, 16, 32, 64)  # bits of the integers that NumPy reads where they lie


@dataclass(frozen=True)
class SignalPlan:
    """Where a signal lies in its frame, and value = raw * scale + offset in `unit`.

    `start` counts bits from the frame's first bit as its byte order numbers them: from the least
    significant bit of byte 0 (little endian), or from the most significant one (big endian).
    """

    name: str
    start: int
    length: int
    big_endian: bool
    signed: bool
    floating: bool
    scale: float
    offset: float
    unit: str


@dataclass(frozen=True)
class MessagePlan:
    """One message of a DBC: its id, its length in bytes, its period in seconds, its signals."""

    name: str
    identifier: int
    extended: bool
    length: int
    period: float | None
    signals: tuple[SignalPlan, ...]

    def signal(self, name: str) -> SignalPlan:
        """The signal of that name."""
        return next(signal for signal in self.signals if signal.name == name)

    def values(self, data: FrameData, name: str) -> Float[np.ndarray, " frame"]:
        """The named signal of all frames, in its unit."""
        return decode_signal(data, self.signal(name))

    def decode(self, data: FrameData) -> dict[str, Float[np.ndarray, " frame"]]:
        """All signals of all frames."""
        return {signal.name: decode_signal(data, signal) for signal in self.signals}


def decode_signal(data: FrameData, signal: SignalPlan) -> Float[np.ndarray, " frame"]:
    """One signal of many frames, in its unit."""
    values = np.empty(len(data))
    for begin in range(0, len(data), BLOCK):
        block = slice(begin, begin + BLOCK)
        np.multiply(raw_values(data[block], signal), signal.scale, out=values[block])
        if signal.offset:
            values[block] += signal.offset
    return values


def raw_values(data: FrameData, signal: SignalPlan) -> Shaped[np.ndarray, " frame"]:
    """One signal of many frames as it was sent: integers (or floats) before scale and offset."""
    kind = "f" if signal.floating else "i" if signal.signed else "u"
    order = ">" if signal.big_endian else "<"
    if signal.length in NATIVE_LENGTHS and signal.start % signal.length == 0:
        size = signal.length // 8
        return data.view(f"{order}{kind}{size}")[:, signal.start // signal.length]
    bits = shifted_bits(data.view(f"{order}u8")[:, 0], signal)
    size = signal.length // 8
    return bits.astype(f"u{size}").view(f"f{size}") if signal.floating else bits


def shifted_bits(words: Shaped[np.ndarray, " frame"], signal: SignalPlan):
    """Push out the bits above the signal, then those below; a signed shift extends the sign."""
    above = signal.start if signal.big_endian else WORD - signal.start - signal.length
    pushed = words.astype(np.uint64) << np.uint64(above)
    below = WORD - signal.length
    return pushed.view(np.int64) >> np.int64(below) if signal.signed else pushed >> np.uint64(below)
