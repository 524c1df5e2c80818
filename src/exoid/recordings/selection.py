"""Some segments of a recording, with what was said of each."""

from collections.abc import Sequence
from dataclasses import replace
from typing import TypeVar

from exoid.recordings.declared.entry import known
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording

Table = TypeVar("Table", Subject, Protocol)


def selection(
    recording: Recording, numbers: Sequence[int], segments: Sequence[Segment] | None = None
) -> Recording:
    """These segments in this order; in their place `segments` that were made of them."""
    count = len(recording.segments)
    kept = [recording.segments[number] for number in numbers] if segments is None else segments
    return replace(
        recording,
        segments=tuple(kept),
        subject=entries(recording.subject, numbers, count),
        protocol=entries(recording.protocol, numbers, count),
    )


def entries(table: Table, numbers: Sequence[int], count: int) -> Table:
    """Of every list that has an entry for each of `count` segments, those of these numbers."""
    each = {entry.name: getattr(table, entry.name) for entry in known(table)}
    lists = {
        name: tuple(value[number] for number in numbers)
        for name, value in each.items()
        if isinstance(value, tuple) and len(value) == count
    }
    return replace(table, **lists)


def alike(recording: Recording) -> list[int]:
    """The numbers of the segments that have the sensors which most have: channel by channel one
    noise is told for all.
    """
    each = [sensed(segment) for segment in recording.segments]
    usual = max(dict.fromkeys(each), key=each.count)
    return [number for number, one in enumerate(each) if one == usual]


def sensed(segment: Segment) -> tuple[bool, bool]:
    """Is its angle raw, and is there a velocity beside it?"""
    raw = segment.raw_angle is not None
    velocity = segment.raw_angular_velocity if raw else segment.angular_velocity
    return raw, velocity is not None
