"""The bits of one frame: from numbers, and to those that are unsigned and little-endian."""

from collections.abc import Mapping

import numpy as np

from exoid.recordings.can.decode import MessagePlan, SignalPlan


def encoded(plan: MessagePlan, values: Mapping[str, float | int]) -> bytes:
    """The data of a frame with these values in their units; a signal that is not named is 0 counts.

    Integers of little-endian signals alone. **Raises** `ValueError` for a value that its signal
    cannot hold.
    """
    bits = 0
    for name, value in values.items():
        signal = plan.signal(name)
        bits |= counts(plan.name, signal, value) % (1 << signal.length) << signal.start
    return bits.to_bytes(plan.length, "little")


def counts(message: str, signal: SignalPlan, value: float | int) -> int:
    """What is sent for a value: the nearest count."""
    count = round((value - signal.offset) / signal.scale)
    lowest = -(1 << signal.length - 1) if signal.signed else 0
    if not lowest <= count < lowest + (1 << signal.length):
        raise ValueError(f"{message}.{signal.name} cannot be {value:g} {signal.unit}".rstrip())
    return count


def unsigned(data: bytes, signal: SignalPlan) -> int:
    """A little-endian unsigned signal of one frame, as it was sent."""
    return int.from_bytes(data, "little") >> signal.start & ((1 << signal.length) - 1)


def values_of(plan: MessagePlan, data: bytes, names: tuple[str, ...]) -> tuple[float, ...]:
    """Signals of one frame, in their units."""
    frame = np.frombuffer(data, np.uint8).reshape(1, -1)
    return tuple(float(plan.values(frame, name)[0]) for name in names)
