"""Signals of one frame, taken out of it as a whole number: a frame at a time, as they come."""

from collections.abc import Callable, Iterable

from exoid.recordings.can.decode import MessagePlan

Word = int  # the eight bytes of a frame, the first one lowest


def reader_of(plan: MessagePlan, name: str) -> Callable[[Word], int]:
    """The function that gives a little-endian signal's count."""
    signal = plan.signal(name)
    start, mask, top = signal.start, (1 << signal.length) - 1, 1 << signal.length - 1
    if not signal.signed:
        return lambda word: word >> start & mask
    return lambda word: ((word >> start & mask) ^ top) - top


def mask_of(plan: MessagePlan, names: Iterable[str]) -> Word:
    """The bits of these signals of one bit each."""
    return sum(1 << plan.signal(name).start for name in names)
