"""Segments that hold nothing to read, beside others that do: they are left out, and said."""

from collections.abc import Sequence
from dataclasses import dataclass

from exoid.files.text_file import Notes
from exoid.recordings.measured.segment import Segment


@dataclass(frozen=True)
class Sound:
    """Which segments of a file are kept, by their numbers there, and what is said of the others."""

    numbers: tuple[int, ...]
    count: int  # of all
    notes: Notes


def sound(segments: Sequence[Segment]) -> Sound:
    """Those with two samples of an angle at least; all where none has, for them to be refused."""
    faults = {n: fault for n, each in enumerate(segments) if (fault := fault_of(each))}
    if len(faults) == len(segments):
        faults = {}
    kept = tuple(n for n in range(len(segments)) if n not in faults)
    notes = [f"segment {n} {fault}: it is left out." for n, fault in faults.items()]
    if kept and faults and min(faults) < kept[-1]:
        now, was = next((now, was) for now, was in enumerate(kept) if now != was)
        notes.append(f"the segments behind count on without a gap: {was} of the file is {now} now.")
    return Sound(kept, len(segments), tuple(notes))


def fault_of(segment: Segment) -> str | None:
    """Why nothing can be read from it."""
    size = segment.time.size
    if size < 2:
        return f"has {size} sample{'' if size == 1 else 's'}"
    if segment.angle is None and segment.raw_angle is None:
        return "holds no angle"
    return None
