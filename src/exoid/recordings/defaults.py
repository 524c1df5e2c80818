"""What is told of many recordings at once, by sidecars that stand above their own."""

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from exoid.files.text_file import Notes
from exoid.recordings.declared.entry import known
from exoid.recordings.sidecar import TABLES, keys_beside, read_columns, read_keys

DEFAULTS = "defaults.toml"  # a sidecar of all recordings of a study at or below its folder
ZERO = ("zero", "angle_zero")  # two answers to one question
Keys = tuple[dict[str, Any], dict[str, Any], Notes]


def keys_told(sidecar: Path, absent: str, defaults: Sequence[Path] = ()) -> Keys:
    """What `keys_beside` gives, and where the sidecar is silent, the `defaults`, the last first."""
    tables, extra, notes = keys_beside(sidecar, absent)
    for path in reversed(defaults):
        general, more, said = read_keys(path)
        tables = {name: filled(tables[name], general[name]) for name in TABLES}
        extra, notes = {**more, **extra}, (*notes, *said)
    return tables, extra, notes


def filled(own: Any, general: Any) -> Any:
    """A table with another's keys where it is silent."""
    told = {each.name: getattr(own, each.name) for each in known(own)}
    told = {name: value for name, value in told.items() if value is not None}
    if told.keys() & {*ZERO}:
        general = replace(general, **dict.fromkeys(ZERO))
    return replace(general, **told, extra_keys={**general.extra_keys, **own.extra_keys})


def columns_told(sidecar: Path, defaults: Sequence[Path] = ()) -> dict[str, str]:
    """What [columns] of the sidecar and of the `defaults` say, the nearest winning."""
    files = [*defaults, *([sidecar] if sidecar.exists() else [])]
    return {own: name for path in files for own, name in read_columns(path).items()}
