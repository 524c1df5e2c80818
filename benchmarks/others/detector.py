"""exoid's own detector of free movements, as `--release` asks it."""

from dataclasses import replace
from pathlib import Path

from exoid.recordings.loading.load import load
from exoid.recordings.motion.drops import find_drops
from exoid.recordings.motion.extent import Extent
from exoid.recordings.recording import Recording
from exoid.recordings.signal.condition import cut
from exoid.recordings.splitting.pieces import find_pieces
from exoid.recordings.splitting.split import kept_parts

Interval = tuple[float, float]  # s


def free_movements(table: Path) -> list[list[Interval]]:
    """Of each segment of a table; a continuous one is cut into its movements first."""
    recording = load(table, whole=True).recording
    if len(recording.segments) > 1:
        return [[each] if each else [] for each in movements(recording)]
    log = recording.segments[0]
    parts = kept_parts(log, find_pieces(log, recording.sensors, "passive"))
    drops = replace(recording, segments=tuple(cut(log, part) for part in parts))
    offsets = [
        float(log.time[part][0]) - float(drop.time[0])
        for part, drop in zip(parts, drops.segments, strict=True)
    ]
    found = zip(movements(drops), offsets, strict=True)
    return [[(each[0] + offset, each[1] + offset) for each, offset in found if each]]


def movements(recording: Recording) -> list[Interval | None]:
    """From where a leg is surely free to its last free sample; None where nothing moves."""
    found = find_drops(recording)
    return [
        (float(segment.time[each.free]), float(segment.time[each.stop - 1]))
        if isinstance(each := found[number], Extent)
        else None
        for number, segment in enumerate(recording.segments)
    ]
