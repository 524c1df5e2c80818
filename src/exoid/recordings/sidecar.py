"""What is known of a recording, in NAME.toml; its keys are those that `recording.py` declares."""

import re
import tomllib
from collections.abc import Mapping
from pathlib import Path
from types import NoneType
from typing import Any, get_args, get_origin

import numpy as np

from exoid.files.replacing import replace_files
from exoid.files.text_file import Notes, naming, near, read_text
from exoid.recordings.declared.check_entries import check_entry
from exoid.recordings.declared.entry import known
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject

TABLES = {"subject": Subject, "protocol": Protocol, "sensors": Sensors}
FOR_FITS = "fit"  # the table of what is fixed, bounded or expected; a fit reads and checks it
DEEPEST = 50  # tables and lists within each other; exoid's own keys need two
TOO_DEEP = f"nests tables or lists more than {DEEPEST} deep. Leave out what exoid does not know."
DECIMAL_COMMA = re.compile(r"^\s*([\w-]+)\s*=\s*([-+]?\d+),(\d+)\s*(?:#.*)?$", re.MULTILINE)
WORD = re.compile(r"^\s*([\w-]+)\s*=\s*([^\W\d_][\w .-]*?)\s*(?:#.*)?$")
LINE = re.compile(r"\(at line (\d+),")
COLUMNS = "columns"  # what the columns of the table beside it are called: [columns]


def read_sidecar(path: str | Path) -> tuple[Subject, Protocol, Sensors, Notes]:
    """What NAME.toml says, and what its owner should be told; for a log whose segments are unknown.

    Lists of one value per segment are not counted here: `Recording` does that.
    """
    tables, _, notes = read_keys(Path(path))
    return tables["subject"], tables["protocol"], tables["sensors"], notes


def write_sidecar(
    subject: Subject,
    protocol: Protocol,
    sensors: Sensors,
    path: str | Path,
    extra_tables: Mapping[str, Any] | None = None,
) -> None:
    """Writes NAME.toml, in full or not at all."""
    replace_files({Path(path): [sidecar_text(subject, protocol, sensors, extra_tables or {})]})


# Keys of older sidecars that say nothing of the leg: kept without a word.
KEPT = ("shank_radius_m",)


def keys_beside(path: Path, absent: str) -> tuple[dict[str, Any], dict[str, Any], Notes]:
    """What `read_keys` gives; nothing is known where there is no file, and that is said."""
    if path.exists():
        return read_keys(path)
    return {name: kind() for name, kind in TABLES.items()}, {}, (absent,)


def read_keys(path: Path) -> tuple[dict[str, Any], dict[str, Any], Notes]:
    """The known tables by name, the unknown ones as they are, and the notes."""
    with naming(path):
        document = parse_toml(path)
        tables = {name: parse_keys(name, document.get(name, {})) for name in TABLES}
        extra = {name: v for name, v in document.items() if name not in (*TABLES, COLUMNS)}
        notes = [
            f"unknown [{name}] is kept, but not used.{near(name, (*TABLES, COLUMNS))}"
            for name in extra
            if name != FOR_FITS
        ]
        for name, table in tables.items():
            notes += [
                f"unknown {key} in [{name}] is kept, but not used.{place(key)}"
                for key in table.extra_keys
                if key not in KEPT
            ]
    return tables, extra, tuple(f"{path}: {note}" for note in notes)


def parse_toml(path: Path) -> dict[str, Any]:
    text = read_text(path)
    try:
        document = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        hint = with_comma(text) or in_quotes(text, str(error))
        raise ValueError(f"is not valid TOML: {error}.{hint}") from error
    except RecursionError as error:
        raise ValueError(TOO_DEEP) from error
    check_depth(document)
    return document


def with_comma(text: str) -> str:
    """A hint where a number has a decimal comma."""
    found = DECIMAL_COMMA.search(text)
    if found is None:
        return ""
    key, whole, rest = found.groups()
    return f" A number has a decimal point here, no comma: {key} = {whole}.{rest}."


def in_quotes(text: str, fault: str) -> str:
    """A hint where the line at fault has a word without quotes."""
    at = LINE.search(fault)
    found = WORD.match(text.splitlines()[int(at[1]) - 1]) if at else None
    return "" if found is None else f' Words stand in quotes: {found[1]} = "{found[2]}".'


def check_depth(document: dict[str, Any]) -> None:
    """Refuse tables and lists within each other that nothing else could walk or write again."""
    inner: list[Any] = [document]
    for _ in range(DEEPEST):
        inner = [each for one in inner for each in (one.values() if isinstance(one, dict) else one)]
        inner = [each for each in inner if isinstance(each, dict | list)]
    if inner:
        raise ValueError(TOO_DEEP)


def read_columns(path: Path) -> dict[str, str]:
    """What [columns] says of the table beside: exoid's column = the column of the file."""
    with naming(path):
        columns = parse_toml(path).get(COLUMNS, {})
        if not isinstance(columns, dict):
            raise ValueError(f"{COLUMNS} must be a table: write [{COLUMNS}] and its keys below.")
        for key, name in columns.items():
            if not isinstance(name, str):
                raise ValueError(
                    f"{key} in [{COLUMNS}] is {name!r:.60}; it must be a text in quotes."
                )
        return dict(columns)


def parse_keys(name: str, document: Any):
    """One table of the sidecar, its known keys checked, its unknown ones kept."""
    if not isinstance(document, dict):
        raise ValueError(f"{name} must be a table: write [{name}] and its keys below.")
    entries = {entry.metadata["key"]: entry for entry in known(TABLES[name])}
    document = in_radians(name, document, entries)
    values = {
        entries[key].name: parse_entry(f"{key} in [{name}]", entries[key], value)
        for key, value in document.items()
        if key in entries
    }
    extra = {key: value for key, value in document.items() if key not in entries}
    return TABLES[name](**values, extra_keys=extra)


def in_radians(name: str, document: Mapping[str, Any], entries: Mapping[str, Any]) -> dict:
    """The keys in the units of their fields: every `_rad` key may be written as `_deg`."""
    degrees = {key.replace("_rad", "_deg"): key for key in entries if key.endswith("_rad")}
    if twice := [key for key in document if degrees.get(key) in document]:
        raise ValueError(f"{twice[0]} and {degrees[twice[0]]} in [{name}] are the same. Keep one.")
    return {
        degrees.get(key, key): converted(f"{key} in [{name}]", value) if key in degrees else value
        for key, value in document.items()
    }


def converted(where: str, value: Any):
    if isinstance(value, list):
        return [converted(where, each) for each in value]
    return float(np.radians(parse_value(where, {"lower": None}, value)))


def place(key: str) -> str:
    """Where an unknown key may belong."""
    keys = {e.metadata["key"]: name for name, table in TABLES.items() for e in known(table)}
    return f" It belongs in [{keys[key]}]." if key in keys else near(key, keys)


def parse_entry(where: str, entry, value: Any):
    """One key: of the type its field declares, a list only where segments may differ."""
    shapes = [get_origin(shape) is tuple for shape in get_args(entry.type) if shape is not NoneType]
    if isinstance(value, list):
        if not any(shapes):
            raise ValueError(f"{where} is a list; it takes one value.")
        if not value:
            raise ValueError(f"{where} is an empty list. Leave the key out.")
        result = tuple(parse_value(where, entry.metadata, each) for each in value)
    elif all(shapes):
        raise ValueError(f"{where} takes a list, one value per segment.")
    else:
        result = parse_value(where, entry.metadata, value)
    check_entry(entry.metadata, result, None)
    return result


def parse_value(where: str, meta: Mapping[str, Any], value: Any) -> float | str | bool:
    if "flag" in meta:
        if isinstance(value, bool):
            return value
        raise ValueError(f"{where} is {value!r:.60}; it must be true or false, without quotes.")
    number = "lower" in meta
    word = "a number, without quotes" if number else "a text in quotes"
    if not isinstance(value, (int, float) if number else str) or isinstance(value, bool):
        raise ValueError(f"{where} is {value!r:.60}; it must be {word}.")
    return float(min(max(value, -1e300), 1e300)) if number and value == value else value


def sidecar_text(subject, protocol, sensors, extra_tables: Mapping[str, Any]) -> str:
    import tomli_w  # only writing needs it

    tables = {
        name: written(table)
        for name, table in zip(TABLES, (subject, protocol, sensors), strict=True)
    }
    return tomli_w.dumps({name: keys for name, keys in tables.items() if keys} | {**extra_tables})


def written(table) -> dict[str, Any]:
    """A table's known keys in plain Python types, then the unknown ones as they were."""
    values = {entry.metadata["key"]: getattr(table, entry.name) for entry in known(table)}
    # NumPy would drop a zero byte at the end of a text.
    plain = {
        key: v if isinstance(v, str) else np.asarray(v).tolist()
        for key, v in values.items()
        if v is not None
    }
    return plain | {**table.extra_keys}
