"""A file to be followed: whose leg it is, what was on it and when, and its samples in order."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, fields, replace
from itertools import pairwise
from pathlib import Path

from exoid.cli.inputs.body import doubted
from exoid.cli.inputs.reading import take, tell
from exoid.cli.live.replay import of_log, of_recording
from exoid.cli.terminal.say import say
from exoid.online.model.model import Node
from exoid.online.recorded import PAUSE, declared, is_smoothed, node_of
from exoid.recordings.can.logs.log_files import FORMATS, read_log
from exoid.recordings.can.node.which import nodes_in
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.live.decoding.node_stream import NodeStream
from exoid.recordings.live.decoding.reading import Reading
from exoid.recordings.recording import Recording
from exoid.recordings.splitting.split import cut_apart
from exoid.watching.estimate.expect import check_subject
from exoid.watching.estimate.load import Load, Mass, mass_of

ANOTHER_SEAT = "the seat was tilted in several ways: follow recordings of one seat each."

SMOOTHED = (
    "its angle was smoothed or interpolated before it came here, which blurs a release: live may "
    "say of a sound leg that the model does not explain it. Follow what was measured, or read the "
    "file with exoid fit."
)


@dataclass(frozen=True, eq=False)
class Opened:
    """A recording that is ready to be played."""

    subject: Subject
    load: Load
    thigh_angle: float  # rad
    parts: Callable[[int], Iterator[list[Reading]]]  # so many frames or samples at a time
    stream: NodeStream | None  # what decodes it, of a log of the node
    node: Node  # the sensors


def open_recording(path: Path, body: dict[str, float], node: int | None, **reading) -> Opened:
    """The file, as `take` reads it with these options of `reading`.

    A log of the node goes frame by frame through what decodes a live one; any other file, and one
    whose angle or sign the sidecar or an option mends, gives its samples as they were read.

    **Raises** `ValueError` where nothing of it can be followed.
    """
    loaded = take(path, whole=True, **reading)
    recording = replace(loaded.recording, subject=told_of(loaded.recording.subject, body))
    check_subject(recording.subject)
    tell(f"{path.name}: {says}" for says in doubted(vars(recording.subject)))
    mended = any(reading.get(name) for name in ("dbc", "flip", "zero")) or is_mended(path)
    of_node = path.suffix.lower() in FORMATS and loaded.quality is not None and not mended
    rate = loaded.quality.clock_rate if of_node and loaded.quality is not None else None
    factor = 1.0 if rate is None else rate.factor
    load, thigh_angle = load_of(recording, factor), thigh_of(recording)
    if not of_node:
        tell_of_pauses(path, len(recording.segments))
        if is_smoothed(recording):
            say(f"exoid: {path.name}: {SMOOTHED}", err=True)
        return Opened(
            recording.subject,
            load,
            thigh_angle,
            lambda many: of_recording(recording, many),
            stream=None,
            node=node_of(recording),
        )
    log = read_log(path)
    stream = NodeStream(node if node is not None else (nodes_in(log.frames) or [0])[0])
    return Opened(
        recording.subject,
        load,
        thigh_angle,
        lambda many: of_log(log, stream, many),
        stream=stream,
        node=with_own_clock(declared(recording)),
    )


def with_own_clock(node: Node) -> Node:
    """The same by the node's clock, as a live one is followed: the log's times are by another."""
    return replace(node, clock=Node.clock, clock_declared=False)


def tell_of_pauses(path: Path, count: int) -> None:
    """That segments, each of which has a clock of its own, are put on one."""
    if count > 1:
        pause = f"{PAUSE:.0f} s after the one before"
        say(
            f"exoid: {path.name}: its {count} segments are followed as one stream, each {pause}.",
            err=True,
        )


def told_of(subject: Subject, body: dict[str, float]) -> Subject:
    """With what options say: of a mass that they name, nothing that the sidecar says holds."""
    names = [each.name for each in fields(subject)] if "added_mass" in body else []
    of_another = dict.fromkeys(each for each in names if each.startswith("added_mass"))
    return replace(subject, **of_another | body)


def is_mended(path: Path) -> bool:
    """Does the sidecar say that the file counts otherwise than exoid?"""
    from exoid.recordings.sidecar import keys_beside

    tables, _, _ = keys_beside(path.with_suffix(".toml"), "")
    sensors = tables.get("sensors") or Sensors()
    return any(getattr(sensors, name) is not None for name in ("flip", "zero", "angle_zero"))


def thigh_of(recording: Recording) -> float:
    """**Raises** `ValueError` where there are several."""
    said = recording.protocol.thigh_angle
    each = set(said) if isinstance(said, tuple) else {said}
    if len(each) > 1:
        raise ValueError(ANOTHER_SEAT)
    return each.pop() or 0.0


def load_of(recording: Recording, factor: float) -> Load:
    """What is on the shank from when on: a mass is changed midway between two movements. Marks were
    put on the computer's clock, on which the node's seconds are `factor` long.
    """
    subject, many = recording.subject, len(recording.segments) > 1
    if not any(numbers(subject.added_mass)) and not many:
        return Load()
    spans = spans_of(recording)
    masses = [mass_in(recording, number) for number in range(len(spans))]
    between = [(end + start) / 2 for (_, end), (start, _) in pairwise(spans)]
    if many:
        return Load((0.0, *between), tuple(masses), tuple(begin for begin, _ in spans[1:]))
    return Load(tuple(each / factor for each in (0.0, *between)), tuple(masses))


def mass_in(recording: Recording, number: int) -> Mass:
    """What was on the shank in a segment."""
    weight, distance = recording.added_mass(number), recording.added_mass_distance(number)
    if weight and distance is None:
        return Mass(weight, placed=False)
    return mass_of(weight, distance)


def numbers(value: float | tuple[float, ...] | None) -> Sequence[float]:
    return value if isinstance(value, tuple) else (value or 0.0,)


def spans_of(recording: Recording) -> list[tuple[float, float]]:
    """Begin and end [s] of every movement, on the stream's clock."""
    log, *others = recording.segments
    if others:
        return one_after_another(recording)
    protocol = recording.protocol
    if protocol.segment_start is not None:
        starts = protocol.segment_start
        ends = protocol.segment_end or (*starts[1:], float(log.time[-1]))
        return list(zip(starts, ends, strict=True))
    if not isinstance(recording.subject.added_mass, tuple):
        return [(0.0, float(log.time[-1]))]
    parts = cut_apart(recording).recording.segments
    return [(each.begins, each.begins + float(each.time[-1])) for each in parts]


def one_after_another(recording: Recording) -> list[tuple[float, float]]:
    """As `of_recording` plays them."""
    found, begin = [], 0.0
    for each in recording.segments:
        end = begin + float(each.time[-1] - each.time[0])
        found.append((begin, end))
        begin = end + PAUSE
    return found
