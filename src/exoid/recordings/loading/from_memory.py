"""A recording from what is in memory: data frames, arrays, lists."""

from collections.abc import Mapping
from dataclasses import replace
from os import PathLike
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

from exoid.files.text_file import naming, near
from exoid.recordings.columns import NUMERIC, TARGETS
from exoid.recordings.conventions.apply import understand
from exoid.recordings.conventions.file_clock import late_starts
from exoid.recordings.declared.entry import known
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.loading.load import load
from exoid.recordings.loading.warn_user import tell
from exoid.recordings.recording import Recording
from exoid.recordings.sidecar import parse_keys
from exoid.recordings.splitting.split import cut_table
from exoid.recordings.tables.arrays import sheet_of_arrays
from exoid.recordings.tables.assemble import assemble
from exoid.recordings.tables.built import build, judging
from exoid.recordings.tables.sheet import Place, Sheet

Tables = tuple[Subject | None, Protocol | None, Sensors | None]

Table = TypeVar("Table", Subject, Protocol, Sensors)

ASK = '{}="..."'  # how a column is named here


def recording(
    data: Any = None,
    /,
    *,
    subject: Subject | Mapping[str, Any] | None = None,
    protocol: Protocol | Mapping[str, Any] | None = None,
    sensors: Sensors | Mapping[str, Any] | None = None,
    whole: bool = False,
    flip: str | None = None,
    zero: str | None = None,
    columns: Mapping[str, str] | None = None,
    **channels: Any,
) -> Recording:
    """A recording from a data frame, from a mapping of arrays, or from arrays by keyword.

    A keyword is a column of exoid's table, such as `time_s`, `raw_angle_deg`, `segment`, or a
    channel in SI (`time`, `angle`, `raw_angular_velocity`); its value is an array, a list, a
    Series, or the name of a column of `data`. What no keyword names is taken where its name is a
    common one, with a warning that says how it was understood. `subject`, `protocol` and `sensors`
    are those classes, or mappings of their fields or of a sidecar's keys. A path is loaded. As
    there, one continuous segment is cut into its movements unless it is to stay `whole`; `flip`,
    `zero` and `columns` mean what they do in `load`.

    **Raises** `ValueError` (one line) for what cannot be a recording.

    >>> time = np.arange(500) * 0.01  # s
    >>> swing = -90 + 60 * np.exp(-0.4 * time) * np.cos(5 * time)  # deg
    >>> recording = exoid.recording(time_s=time, raw_angle_deg=swing, subject={"kind": "leg"})
    >>> len(recording.segments)
    1
    """
    chosen = {name: each for name, each in channels.items() if isinstance(each, str)}
    chosen |= columns or {}
    tables = (
        table_of(Subject, "subject", subject),
        table_of(Protocol, "protocol", protocol),
        table_of(Sensors, "sensors", sensors),
    )
    if isinstance(data, str | PathLike):
        loaded = load(Path(data), columns=chosen, whole=whole, flip=flip, zero=zero)
        tell(loaded.notes)
        return described(loaded.recording, tables)
    with naming(Path("recording")):
        arrays = {own_name(name): each for name, each in channels.items() if name not in chosen}
        sheet = sheet_of({**arrays_of(data), **arrays}, [*arrays])
        rate = None if tables[2] is None else tables[2].sample_rate
        measured = tables[1] is not None and tables[1].measured
        named = assemble(sheet, chosen, rate, measured=measured)
        built = build(named, judging(tables[0]))
        found, more = understand(
            built.described(given(tables)), cut_table, whole=whole, flip=flip, zero=zero
        )
    notes = (*named.notes, *built.notes, *late_starts(found), *more)
    tell(f"recording: {note}" for note in notes)
    return found


def described(recording: Recording, tables: Tables) -> Recording:
    """With what was given of subject, protocol and sensors."""
    return replace(recording, **given(tables))


def given(tables: Tables) -> dict[str, Any]:
    """Those of subject, protocol and sensors that were given, by name."""
    names = ("subject", "protocol", "sensors")
    return {name: each for name, each in zip(names, tables, strict=True) if each is not None}


def own_name(keyword: str) -> str:
    """The column that a keyword stands for; without a unit it is in SI."""
    if keyword not in TARGETS:
        raise ValueError(f"there is no column {keyword}.{near(keyword, {*NUMERIC, *TARGETS})}")
    target = TARGETS[keyword]
    return keyword if target.size is not None else target.column


def arrays_of(data: Any) -> dict[str, Any]:
    """The columns of a frame, a mapping or a structured array, by name."""
    if data is None:
        return {}
    if isinstance(data, Mapping):
        return dict(data)
    if isinstance(data, np.ndarray) and data.dtype.names:
        return {name: data[name] for name in data.dtype.names}
    if not isinstance(data, np.ndarray) and hasattr(data, "columns"):
        index = getattr(data, "index", None)
        first = {} if index is None or index.name is None else {str(index.name): index}
        return first | {str(name): data[name] for name in data.columns}
    raise ValueError(
        f"{type(data).__name__} has no names: give a data frame, a dict of arrays, or keywords "
        "such as time_s=..., raw_angle_deg=...."
    )


def sheet_of(arrays: Mapping[str, Any], needed: list[str]) -> Sheet:
    """The arrays as a table; those that were given by keyword must all be in it."""
    if not arrays:
        raise ValueError("nothing was given. It needs time_s=... and raw_angle_deg=... at least.")
    sheet = replace(sheet_of_arrays(arrays, Place("row")), ask=ASK)
    size = len(sheet.columns[0].cells)
    for name in needed:
        if sheet.column(name) is None:
            raise ValueError(
                f"{name} has the shape {np.shape(arrays[name])}, where {size} samples are wanted."
            )
    return sheet


def table_of(kind: type[Table], name: str, given: Table | Mapping[str, Any] | None) -> Table | None:
    """Subject, protocol or sensors, or a mapping of their fields or of a sidecar's keys."""
    if given is None or isinstance(given, kind):
        return given
    keys = {entry.name: entry.metadata["key"] for entry in known(kind)}
    wanted = {keys.get(key, key): listed_value(each) for key, each in given.items()}
    unknown = [key for key in wanted if key not in keys.values()]
    if unknown:
        raise ValueError(f"{name} has no {unknown[0]}.{near(unknown[0], keys)}")
    return parse_keys(name, wanted)


def listed_value(value: Any) -> Any:
    """As a sidecar would hold it: plain numbers, texts and lists."""
    plain = value.tolist() if isinstance(value, np.ndarray | np.generic) else value
    return list(plain) if isinstance(plain, tuple) else plain
