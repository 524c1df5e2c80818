"""A recording out of Motion-BIDS: exoid's own with every number, or a joint angle of others."""

import json
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from exoid.files.text_file import Notes, naming, read_text
from exoid.recordings.columns import NUMERIC, SEGMENT
from exoid.recordings.conventions.apply import understand
from exoid.recordings.conventions.file_clock import late_starts
from exoid.recordings.declared.subject import SIDES, Subject
from exoid.recordings.recording import Recording
from exoid.recordings.sidecar import TABLES, parse_keys
from exoid.recordings.splitting.split import cut_table
from exoid.recordings.tables.assemble import Named, assemble
from exoid.recordings.tables.built import build
from exoid.recordings.tables.sheet import Place, Sheet
from exoid.studies.dataset.motion_bids.channels import LATENCY, OWN_UNITS
from exoid.studies.dataset.motion_bids.labels import inherited
from exoid.studies.dataset.motion_bids.samples import Channels, read_channels
from exoid.studies.dataset.motion_bids.write_motion import OWN
from exoid.studies.dataset.tables.cells import rows_of

Told = dict[str, Any]
OF_LEG = ("knee", "shank", "tibia")
SAYING = ("name", "tracked_point", "placement")
CHANNEL_OF = {"LATENCY": "time", "JNTANG": "raw_angle", "GYRO": "raw_angular_velocity"}


def read_motion(path: Path, *, whole: bool = False) -> tuple[Recording, Notes]:
    """The recording in NAME_motion.tsv, with its channels, events and metadata, cut as `load` does;
    and what its owner should be told.

    **Raises** `ValueError` in one line, and `OSError`.
    """
    told = metadata_of(path)
    tables, extra = sidecar_of(path, told)
    channels = read_channels(path)
    with naming(path):
        side = tables["subject"].side or side_of(path)
        own = is_own(channels)
        named = own_columns(path, channels) if own else others_columns(channels, told, side)
        built = build(named, Subject(kind=tables["subject"].kind))
        recording = built.described(tables | {"extra_tables": extra})
        notes = (*named.notes, *built.notes, *late_starts(recording))
        recording, more = understand(recording, cut_table, whole=whole)
    return recording, tuple(f"{path}: {note}" for note in (*notes, *more))


def metadata_of(path: Path) -> Told:
    """What the `_motion.json` beside it and above it say; the nearest wins."""
    told: Told = {}
    for each in inherited(path, "_motion.json"):
        with naming(each):
            try:
                document = json.loads(read_text(each))
            except (json.JSONDecodeError, RecursionError) as fault:
                raise ValueError(f"is not valid JSON: {fault}.") from fault
            if not isinstance(document, dict):
                raise ValueError("holds no JSON object: write { and } around its keys.")
        told |= document
    return told


def sidecar_of(path: Path, told: Told) -> tuple[Told, Told]:
    """What exoid keeps there of subject, protocol and sensors, and of what it does not know."""
    document = told.get(OWN, {})
    with naming(path.with_suffix(".json")):
        if not isinstance(document, dict):
            raise ValueError(f'"{OWN}" must be an object with subject, protocol and sensors.')
        tables = {name: parse_keys(name, with_nan(document.get(name, {}))) for name in TABLES}
    return tables, {name: each for name, each in document.items() if name not in TABLES}


def with_nan(table: Any) -> Any:
    """JSON has no number that is none: in a list, null stands for it."""
    if not isinstance(table, dict):
        return table
    return {
        key: [float("nan") if each is None else each for each in value]
        if isinstance(value, list)
        else value
        for key, value in table.items()
    }


def is_own(channels: Channels) -> bool:
    """Were these channels named by exoid, with its units?"""
    units = {each.name: each.unit for each in channels.columns}
    known = {name: unit for name, unit in units.items() if name in OWN_UNITS}
    return {"time_s"} < known.keys() and all(OWN_UNITS[k] == unit for k, unit in known.items())


def own_columns(path: Path, channels: Channels) -> Named:
    columns = {each.name: each.cells for each in channels.columns if each.name != LATENCY}
    size = len(columns["time_s"])
    columns[SEGMENT] = segments_of(path, size)
    others = [name for name in columns if name not in NUMERIC]
    notes = tuple(f"unknown column {name} is kept as text." for name in others)
    return Named(columns, Place("line", 1), {}, notes)


def segments_of(path: Path, size: int) -> np.ndarray:
    """The number of the segment of every sample, by the events that say at which one it begins."""
    tables = inherited(path, "_events.tsv")
    if not tables:
        return np.zeros(size)
    with naming(tables[-1]):
        cells = [row.cells.get("sample", "") for row in rows_of(tables[-1])]
        starts = [int(each) for each in cells if each.isdecimal()]
        if starts[:1] != [0] or any(a >= b for a, b in pairwise([*starts, size])):
            raise ValueError(
                f"its segments begin at the samples {starts[:8]} of {size}: the first must be 0, "
                "and each lie behind the one before."
            )
    return np.searchsorted(starts, np.arange(size), side="right") - 1.0


def others_columns(channels: Channels, told: Told, side: str) -> Named:
    """Of another's channels the knee's angle, its gyro and the time, where they are told apart."""
    names = {}
    for kind, target in CHANNEL_OF.items():
        of_kind = [row for row in channels.rows if row["type"].upper() == kind]
        likely = having(having(of_kind, OF_LEG), (side,))
        names |= {row["name"]: target for row in likely if len(likely) == 1}
    columns = tuple(replace(c, name=names.get(c.name, c.name)) for c in channels.columns)
    rate = rate_of(told.get("SamplingFrequency"))
    sheet = Sheet(columns, Place("line", 1), rate, ask="call it {} in _channels.tsv")
    return assemble(sheet, {})


def having(rows: list[dict[str, str]], words: tuple[str, ...]) -> list[dict[str, str]]:
    """The channels that say one of these words of themselves; all, where none does."""
    said = [" ".join(row.get(key, "") for key in SAYING).lower() for row in rows]
    found = [row for row, text in zip(rows, said, strict=True) if any(w in text for w in words)]
    return found or rows


def side_of(path: Path) -> str:
    """The side that a file name tells by its `acq-` entity."""
    words = path.name.split("_")
    return next((side for side in SIDES if f"acq-{side}" in words), "")


def rate_of(told: Any) -> float | None:
    """A rate [Hz] where it can be one."""
    return float(told) if isinstance(told, int | float) and 0 < told < float("inf") else None
