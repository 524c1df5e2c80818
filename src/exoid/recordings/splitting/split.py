"""A continuous recording, cut into its drops and cycles; what a hand moved is left out by name."""

from dataclasses import dataclass, replace

import numpy as np

from exoid.files.counted import counted, some_of
from exoid.recordings.declared.entry import known
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.measured.segment import Segment
from exoid.recordings.motion.extent import Motionless
from exoid.recordings.motion.thresholds import PAUSE, REST_KEPT, TAKEN
from exoid.recordings.recording import Recording
from exoid.recordings.signal.condition import classify, cut
from exoid.recordings.splitting.cycle import find_cycle
from exoid.recordings.splitting.lifted import without_lifts
from exoid.recordings.splitting.piece import Piece
from exoid.recordings.splitting.pieces import find_pieces
from exoid.recordings.splitting.rig import free_alone, free_part
from exoid.recordings.splitting.unsaid import of_unsaid

SHOWN = 8  # of what was left out, by their times: a line that can be read
Marks = tuple[float, ...]  # s, on the log's clock


@dataclass(frozen=True, eq=False)
class Split:
    """The segments, and what was left out between them."""

    recording: Recording
    notes: tuple[str, ...]


def split(recording: Recording) -> Recording:
    """`cut_apart`, without its notes."""
    return cut_apart(recording).recording


def cut_apart(recording: Recording) -> Split:
    """A log of one segment, cut into its cycles and drops; anything else is returned as it is.

    `protocol.segment_start` and `segment_end` say where, when given [s on the log's clock].
    Otherwise rests separate movements, each keeps up to 0.5 s of the rest before it, and what a
    hand moved is left out. Kind and cycle period are filled in where the sidecar is silent.
    """
    log, *others = recording.segments
    if others:
        return Split(recording, ())
    starts, ends = recording.protocol.segment_start, recording.protocol.segment_end
    if starts is not None:
        return Split(of_parts(recording, marked_parts(log, starts, ends)), ())
    pieces = find_pieces(log, recording.sensors, recording.protocol.kind)
    parts = without_lifts(log, recording.sensors, kept_parts(log, pieces), pieces)
    if not parts:
        raise ValueError(
            "no movement was found: no drop or cycle between two rests. Mark the segments with "
            "segment_start_s and segment_end_s."
        )
    return Split(of_parts(recording, parts), notes_of(log, pieces))


def cut_table(recording: Recording) -> Split:
    """A table is cut as a log is, where it holds more than one movement.

    Otherwise it is returned as it is. What is taken for a voluntary movement unsaid is said.
    """
    log, *others = recording.segments
    if others or recording.protocol.segment_start is not None:
        found = cut_apart(recording)
    else:
        said = for_all(recording)
        found = cut_rig(said, log) if said.subject.kind == "rig" else cut_leg(said, log)
        found = found or Split(recording, ())
    return replace(found, notes=(*found.notes, *of_unsaid(recording.protocol, found.recording)))


def cut_leg(said: Recording, log: Segment) -> Split | None:
    """None where it holds no more than one movement."""
    kind = said.protocol.kind
    if kind == "measured":
        return None
    pieces = find_pieces(log, said.sensors, kind)
    parts = without_lifts(log, said.sensors, kept_parts(log, pieces), pieces)
    if not parts or len(pieces) < 2 or (kind == "active" and len(parts) < 2):
        return None
    return Split(of_parts(said, parts), notes_of(log, pieces))


def cut_rig(said: Recording, log: Segment) -> Split | None:
    """The same of a rig's, in which only what swings is surely free."""
    if said.protocol.kind in ("active", "measured") or log.applied_torque is not None:
        return None
    pieces = free_alone(log, find_pieces(log, said.sensors, "passive"))
    swung = [each for each in pieces if each.kind is not None]
    if not swung or len(pieces) < 2:
        return None
    parts = [
        free_part(log, said.sensors, part, each)
        for part, each in zip(kept_parts(log, pieces), swung, strict=True)
    ]
    free = replace(said, protocol=replace(said.protocol, kind="passive"))
    return Split(of_parts(free, parts), notes_of(log, pieces, "rig"))


def for_all(recording: Recording) -> Recording:
    """What is said of the one segment is said of all that it is cut into."""

    def told(table):
        each = {entry.name: getattr(table, entry.name) for entry in known(table)}
        single = {k: v[0] for k, v in each.items() if isinstance(v, tuple) and len(v) == 1}
        single = {k: None if v != v else v for k, v in single.items()}
        return replace(table, **single)

    return replace(recording, subject=told(recording.subject), protocol=told(recording.protocol))


def kept_parts(log: Segment, pieces: list[Piece]) -> list[slice]:
    """Every drop and cycle with the rest before it; a drop lasts until a hand takes the leg for the
    next movement, or the log pauses.
    """
    pauses = np.flatnonzero(np.diff(log.time) > PAUSE) + 1  # the first samples after them
    parts = []
    for number, piece in enumerate(pieces):
        if piece.kind is None:
            continue
        before = pieces[number - 1].stop if number else 0
        rest = int(np.searchsorted(log.time, log.time[piece.start] - REST_KEPT))
        stop = piece.stop
        if piece.kind == "passive":
            stop = log.time.size
            if number + 1 < len(pieces):
                taken = log.time[pieces[number + 1].start] - TAKEN
                stop = max(piece.stop, int(np.searchsorted(log.time, taken)))
            stop = min(stop, *map(int, pauses[pauses >= piece.stop]), log.time.size)
        parts.append(slice(max(rest, before), stop))
    return parts


def notes_of(log: Segment, pieces: list[Piece], what: str = "leg") -> tuple[str, ...]:
    """What was left out, by its time; a lift at the end of a drop, too."""
    each = [
        (each.name, each.start, each.stop) if each.kind is None else ("a lift", lift, each.stop)
        for each in pieces
        if (lift := each.lifted) is not None or each.kind is None
    ]
    left = [
        f"{name} from {log.time[start]:.1f} to {log.time[stop - 1]:.1f} s"
        for name, start, stop in each
    ]
    said = f"left out, for a hand moved the {what}: {some_of(left, SHOWN, 'more times')}"
    return (said,) if left else ()


def marked_parts(log: Segment, starts: Marks, ends: Marks | None) -> list[slice]:
    """The samples between the marks; without end marks each segment lasts until the next."""
    parts = []
    ends = ends or (*starts[1:], float(log.time[-1]))
    for number, (start, end) in enumerate(zip(starts, ends, strict=True)):
        inside = np.flatnonzero((log.time >= start) & (log.time <= end))
        if inside.size < 2:
            raise ValueError(
                f"segment {number} is marked from {start:g} to {end:g} s, where the log has "
                f"{counted(inside.size, 'sample')}; it runs from {log.time[0]:g} to "
                f"{log.time[-1]:g} s. "
                "Is the log cut? Take this segment out of segment_start_s, segment_end_s and every "
                "list of the sidecar that has one entry for each segment."
            )
        parts.append(slice(int(inside[0]), int(inside[-1]) + 1))
    return parts


def of_parts(recording: Recording, parts: list[slice]) -> Recording:
    log = recording.segments[0]
    segments = [cut(log, part) for part in parts]
    protocol = describe(recording.protocol, segments, recording.sensors)
    return replace(recording, segments=tuple(segments), protocol=protocol)


def describe(protocol: Protocol, segments: list[Segment], sensors: Sensors) -> Protocol:
    """The protocol of the segments, the marks gone and what was missing filled in."""
    kind = protocol.kind or tuple(classify(segment) or "passive" for segment in segments)
    period = protocol.cycle_period
    if period is None and "active" in kind:
        kinds = kind if isinstance(kind, tuple) else (kind,) * len(segments)
        period = tuple(
            measure_period(segment, sensors) if each == "active" else np.nan
            for each, segment in zip(kinds, segments, strict=True)
        )
    return replace(protocol, kind=kind, cycle_period=period, segment_start=None, segment_end=None)


def measure_period(segment: Segment, sensors: Sensors) -> float:
    """The time [s] from the onset of a movement to its return; nan if nothing moves."""
    try:
        return find_cycle(segment, sensors).duration
    except Motionless:
        return np.nan
