"""A log of any other device as one segment: its DBC, and a map from channels to its signals."""

import re
from dataclasses import dataclass, fields, replace
from difflib import get_close_matches
from pathlib import Path

import numpy as np

from exoid.recordings.can.dbc import plan_message, read_dbc
from exoid.recordings.can.frames import CanLogError, Log
from exoid.recordings.can.quality import LogQuality, MessageCount, gaps_in
from exoid.recordings.can.sort import MessageFrames, SortedFrames, sort_frames
from exoid.recordings.can.track import Track, told, track_of
from exoid.recordings.can.units import size_in
from exoid.recordings.filter.effect import filter_effect
from exoid.recordings.measured.segment import Segment

CHANNELS = {
    entry.name: entry.metadata["unit"]
    for entry in fields(Segment)
    if "column" in entry.metadata and entry.name != "time"
}
AS_IN_TABLES = {"velocity": "angular_velocity", "raw_velocity": "raw_angular_velocity"}
NAMED = re.compile(r"^(?:(?P<message>\w+)\.)?(?P<signal>\w+)(?:\s*\[(?P<unit>.*)\])?$")
FARTHEST = 2.0  # periods; a value farther from its neighbours is not interpolated


@dataclass(frozen=True)
class Source:
    """Where a channel comes from: a signal of a message, and the size of its unit in SI."""

    channel: str
    message: str
    signal: str
    size: float


def read_signals(log: Log, dbc: Path, signals: dict[str, str]) -> tuple[Segment, LogQuality]:
    """The mapped signals of a log, on the times of the message that holds the angle.

    Such frames carry no counter: their time is a straight line through the host's, so that its
    jitter is gone. A channel of another message is interpolated between its two neighbours.

    **Raises** `CanLogError` for a map or a DBC that does not fit the log.
    """
    sources, plans = resolve(signals, one_per_name(read_dbc(dbc), log), dbc)
    ordered = sort_frames(log.frames, plans)
    tracks = {name: track_of(log, each) for name, each in ordered.messages.items()}
    leading = next(s.message for s in sources if s.channel in ("angle", "raw_angle"))
    time = tracks[leading].time
    channels = {
        source.channel: aligned(ordered.messages[source.message], source, tracks, time)
        for source in sources
    }
    for source in sources:
        if np.isnan(channels[source.channel]).all():
            raise CanLogError(
                f"{log.path}: {source.message}.{source.signal} ({source.channel}) has no value "
                f"while {leading} is sent. Leave it out of the map."
            )
    segment = replace(Segment(time - time[0]), **channels)
    quality = quality_of(log, ordered, tracks, leading)
    return segment, replace(quality, filter=filter_effect(segment))


def resolve(signals: dict[str, str], messages: list, dbc: Path):
    """What each entry of the map means, and the plans of the messages it needs."""
    if not {"angle", "raw_angle"} & signals.keys():
        raise CanLogError('The signal map names no angle: give "angle" or "raw_angle".')
    signals = {AS_IN_TABLES.get(channel, channel): name for channel, name in signals.items()}
    if unknown := signals.keys() - CHANNELS.keys():
        raise CanLogError(
            f"The signal map knows no channel {', '.join(sorted(unknown))}; "
            f"it can be {', '.join(CHANNELS)}."
        )
    sources = [source_of(channel, name, messages, dbc) for channel, name in signals.items()]
    wanted: dict[str, tuple[str, ...]] = {}
    for source in sources:
        wanted[source.message] = (*wanted.get(source.message, ()), source.signal)
    by_name = {message.name: message for message in messages}
    plans = [plan_message(by_name[name], names) for name, names in wanted.items()]
    return sources, plans


def one_per_name(messages: list, log: Log) -> list:
    """Of messages with the same name, the one whose id is in the log."""
    seen = set(np.unique(log.frames.identifier).tolist())
    by_name = {each.name: each for each in sorted(messages, key=lambda m: m.frame_id in seen)}
    return list(by_name.values())


def source_of(channel: str, name: str, messages: list, dbc: Path) -> Source:
    parts = NAMED.match(name.strip())
    if parts is None:
        raise CanLogError(f'{channel} = "{name}": write MESSAGE.SIGNAL, SIGNAL, or SIGNAL [unit].')
    found = [
        (message.name, signal)
        for message in messages
        for signal in message.signals
        if signal.name == parts["signal"] and parts["message"] in (None, message.name)
    ]
    if len(found) > 1:
        places = ", ".join(f"{message}.{signal.name}" for message, signal in found)
        raise CanLogError(f'{channel} = "{name}" can be {places} in {dbc}. Name the message too.')
    if not found:
        raise CanLogError(f'{channel} = "{name}": {dbc} has no such signal.{hint(name, messages)}')
    message, signal = found[0]
    unit = signal.unit or "" if parts["unit"] is None else parts["unit"]
    size = size_in(CHANNELS[channel], unit, f"{message}.{signal.name}")
    return Source(channel, message, signal.name, size)


def hint(name: str, messages: list) -> str:
    known = [f"{message.name}.{signal.name}" for message in messages for signal in message.signals]
    known += [signal.name for message in messages for signal in message.signals]
    near = get_close_matches(name, known, n=3)
    return f" Did you mean {', '.join(near)}?" if near else ""


def aligned(message: MessageFrames, source: Source, tracks: dict[str, Track], time):
    """A channel at the given times."""
    values = message.values(source.signal) * source.size
    track = tracks[source.message]
    if track.time is time:
        return values
    after = np.clip(np.searchsorted(track.time, time), 1, track.time.size - 1)
    apart = track.time[after] - track.time[after - 1]
    inside = (time >= track.time[0]) & (time <= track.time[-1])
    near = inside & (apart <= FARTHEST * track.period)
    return np.where(near, np.interp(time, track.time, values), np.nan)


def quality_of(
    log: Log, ordered: SortedFrames, tracks: dict[str, Track], leading: str
) -> LogQuality:
    track = tracks[leading]
    steps = np.where(track.regular, np.diff(track.count), 1)
    return LogQuality(
        path=str(log.path),
        frames=ordered.counts,
        clock="host",
        samples=track.time.size,
        messages=tuple(
            MessageCount(
                name,
                int(each.count[-1]) + 1 if each.regular else each.count.size,
                each.count.size,
                int((np.diff(each.count) > 1).sum()) if each.regular else 0,
            )
            for name, each in tracks.items()
        ),
        gaps=tuple(gaps_in(track.time - track.time[0], steps)),
        host_jitter=track.jitter if track.regular else None,
        announced=log.announced,
        found=log.found,
        stopped=log.stopped,
        notes=tuple(
            told(name, each) + ("" if each is track else f", interpolated to those of {leading}")
            for name, each in tracks.items()
        ),
    )
