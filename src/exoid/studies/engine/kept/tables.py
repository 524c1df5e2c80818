"""The two tables of a study."""

from collections.abc import Iterable
from importlib.metadata import version
from typing import Any

import pyarrow as pa

from exoid.studies.engine.kept.item import Item
from exoid.studies.engine.kept.measured import Measured, facts

TEXT, NUMBER, COUNT = pa.string(), pa.float64(), pa.int64()
WHOSE = [(name, TEXT) for name in ("recording", "name", "participant", "session", "side")]
WHOSE += [("task", TEXT), ("run", TEXT)]
KEY = ("key", TEXT)  # of a part only
RECORDINGS = pa.schema(
    [
        KEY,
        *WHOSE,
        *((name, TEXT) for name in ("status", "reason", "duplicate_of")),
        ("segments", COUNT),
        ("samples", COUNT),
        ("duration_s", NUMBER),
        ("rate_hz", NUMBER),
        ("device", TEXT),
        *((name, NUMBER) for name in ("body_mass_kg", "height_m", "age_years")),
        ("exoid", TEXT),
    ]
)
QUANTITIES = pa.schema(
    [
        KEY,
        *WHOSE,
        ("segment", COUNT),
        ("step", TEXT),
        ("quantity", TEXT),
        ("value", NUMBER),
        ("standard_error", NUMBER),
        ("if_slack", NUMBER),
        *((name, TEXT) for name in ("unit", "determined_by", "note")),
    ]
)


def recordings_table(each: Iterable[Measured]) -> pa.Table:
    """A row for every recording of a batch."""
    return pa.Table.from_pylist([recording_row(one) for one in each], RECORDINGS)


def recording_row(one: Measured) -> dict[str, Any]:
    return {
        "key": one.item.key,
        **whose(one),
        "status": "ok" if one.fault is None else "failed",
        "reason": one.fault or "",
        "duplicate_of": "",
        "device": "",
        **facts(one),
        "exoid": version("exoid"),
    }


def quantities_table(each: Iterable[Measured]) -> pa.Table:
    """A row for every quantity of a batch."""
    rows = [{"key": one.item.key, **whose(one), **vars(row)} for one in each for row in one.rows]
    return pa.Table.from_pylist(rows, QUANTITIES)


def whose(one: Measured) -> dict[str, str]:
    """Which recording of whom a row is of."""
    own = whose_item(one.item)
    if one.recording is None:
        return own
    subject = one.recording.subject
    said = {"participant": subject.id, "session": subject.session, "side": subject.side}
    return own | {name: value for name, value in said.items() if value}


def whose_item(item: Item) -> dict[str, str]:
    """The same of one that was not read."""
    entry = item.entry
    told = {name: getattr(entry, name) for name in ("name", "participant", "session", "side")}
    return {"recording": item.recording, **told, "task": entry.task, "run": entry.run}
