"""A recording as the four files of Motion-BIDS: samples, channels, events, and what is known."""

import json
from collections import Counter
from datetime import date, time
from math import isfinite
from pathlib import Path
from typing import Any

import numpy as np

from exoid.files.replacing import replace_files
from exoid.recordings.columns import SEGMENT
from exoid.recordings.flat_table import flat
from exoid.recordings.rate import rate_of
from exoid.recordings.recording import Recording
from exoid.recordings.sidecar import TABLES, written
from exoid.studies.dataset.motion_bids.channels import CHANNELS, LATENCY, OWN_UNITS, UNKNOWN
from exoid.studies.dataset.motion_bids.labels import beside
from exoid.studies.dataset.tables.tsv import MISSING, cell, tsv

OWN = "exoid"  # the key of `_motion.json` below which exoid keeps its sidecar
FIRST = ("name", "component", "type", "tracked_point", "units")  # in this order, BIDS says


def write_motion(recording: Recording, path: Path, task: str) -> None:
    """Writes NAME_motion.tsv and what belongs to it, such that `read_motion` gives back every
    number. Units are SI, stated for each channel; the segments are events.
    """
    columns = {name: each for name, each in flat(recording.segments).items() if name != SEGMENT}
    columns = {LATENCY: latency(recording), **columns}
    texts = [lines(each) for each in columns.values()]
    replace_files(
        {
            beside(path, "_channels.tsv"): [tsv(channel_rows(recording, [*columns]))],
            beside(path, "_events.tsv"): [tsv(event_rows(recording, columns[LATENCY]))],
            beside(path, "_motion.json"): [json_text(metadata(recording, [*columns], task))],
            path: ["".join("\t".join(row) + "\n" for row in zip(*texts, strict=True))],
        }
    )


def lines(cells: Any) -> list[str]:
    return [*map(cell, cells.tolist() if isinstance(cells, np.ndarray) else cells)]


def latency(recording: Recording) -> np.ndarray:
    """The time of all samples on one clock [s].

    Where the segments lie on the clock of the log that they were cut from, else one after another.
    """
    starts, end = [], -np.inf
    for each in recording.segments:
        starts.append(each.begins if each.begins + each.time[0] > end else None)
        end = each.begins + each.time[-1]
    if None in starts:
        spans = [each.time[-1] - each.time[0] + step(each.time) for each in recording.segments]
        ends = np.concatenate([[0.0], np.cumsum(spans)])
        starts = [s - each.time[0] for s, each in zip(ends, recording.segments, strict=False)]
    times = [s + each.time for s, each in zip(starts, recording.segments, strict=True)]
    return np.concatenate(times) - times[0][0]


def step(time: np.ndarray) -> float:
    return float(np.median(np.diff(time)))


def channel_rows(recording: Recording, names: list[str]) -> list[list[str]]:
    side = recording.subject.side or ""
    point, placement = f"{side.capitalize()}Knee", f"{side} knee".strip()
    rows = [[*FIRST, "placement", "description"]]
    for name in names:
        own = CHANNELS.get(name, UNKNOWN)
        units = OWN_UNITS.get(name, MISSING)
        rows.append([name, own.component, own.type, point, units, placement, own.description])
    return rows


def event_rows(recording: Recording, times: np.ndarray) -> list[list[object]]:
    """The segments; `sample` is the number of their first row."""
    rows: list[list[object]] = [["onset", "duration", "trial_type", "sample"]]
    first = 0
    for number, each in enumerate(recording.segments):
        last = first + each.time.size - 1
        duration = float(times[last] - times[first])
        rows.append([float(times[first]), duration, recording.kind(number), first])
        first = last + 1
    return rows


def metadata(recording: Recording, names: list[str], task: str) -> dict[str, Any]:
    """What Motion-BIDS asks for, and exoid's own sidecar."""
    kinds = Counter(CHANNELS.get(name, UNKNOWN).type for name in names)
    counts = {f"{kind}ChannelCount": count for kind, count in sorted(kinds.items())}
    effective = rate_of(recording.segments)
    tables = {name: written(getattr(recording, name)) for name in TABLES}
    return {
        "TaskName": task,
        "TaskDescription": "movements of a lower leg about the knee",
        "SamplingFrequency": recording.sensors.sample_rate or effective,
        "SamplingFrequencyEffective": effective,
        "TrackingSystemName": "knee exoskeleton",
        "TrackedPointsCount": 1,
        "MotionChannelCount": len(names),
        **counts,
        "MissingValues": MISSING,
        OWN: {k: v for k, v in tables.items() if v} | {**recording.extra_tables},
    }


def json_text(document: dict[str, Any]) -> str:
    return json.dumps(plain(document), indent=2, ensure_ascii=False, allow_nan=False) + "\n"


def plain(value: Any) -> Any:
    """As JSON can hold it: a number that is none is null, a date its words."""
    if isinstance(value, dict):
        return {key: plain(each) for key, each in value.items()}
    if isinstance(value, list | tuple):
        return [plain(each) for each in value]
    if isinstance(value, float) and not isfinite(value):
        return None
    return value.isoformat() if isinstance(value, date | time) else value
