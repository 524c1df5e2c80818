"""exoid's own detector of free movements, as `--release` asks it."""

from pathlib import Path

from exoid.recording.condition import cut
from exoid.recording.load import load
from exoid.recording.motion.extent import Motionless, find_extent
from exoid.recording.motion.pieces import find_pieces
from exoid.recording.motion.split import kept_parts
from exoid.recording.recording import Segment, Sensors

Interval = tuple[float, float]  # s


def free_movements(table: Path) -> list[list[Interval]]:
    """Of each segment of a table; a continuous one is cut into its movements first."""
    recording = load(table, whole=True).recording
    sensors = recording.sensors
    if len(recording.segments) > 1:
        return [movements(each, sensors, [slice(None)]) for each in recording.segments]
    log = recording.segments[0]
    return [movements(log, sensors, kept_parts(log, find_pieces(log, sensors, "passive")))]


def movements(segment: Segment, sensors: Sensors, parts: list[slice]) -> list[Interval]:
    """From where a leg is surely free to its last free sample."""
    found = []
    for part in parts:
        try:
            extent = find_extent(cut(segment, part), sensors)
        except Motionless:
            continue
        time = segment.time[part]
        found.append((float(time[extent.free]), float(time[extent.stop - 1])))
    return found
