"""A recording on disk, format version 1: the samples in NAME.csv, what is known in NAME.toml.

Columns and keys are those that `recording.py` declares; this file holds no second list of them.
A table in exoid's own words is read to the letter; one in another's is understood in `tables/`.
"""

import csv
import io
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from exoid.files.extras import require
from exoid.files.replacing import replace_files
from exoid.files.text_file import Notes, naming
from exoid.recordings.columns import IN_DEGREES
from exoid.recordings.conventions.file_clock import late_starts
from exoid.recordings.defaults import columns_told, keys_told
from exoid.recordings.flat_table import flat
from exoid.recordings.formats.delimited import is_own, legible, sheet_of_text
from exoid.recordings.formats.sheets import TEXTS, read_sheet
from exoid.recordings.recording import Recording
from exoid.recordings.sidecar import sidecar_text
from exoid.recordings.tables.assemble import Named, assemble
from exoid.recordings.tables.built import build, judging
from exoid.recordings.tables.own_cells import FIRST_LINE, check_names, parse_table
from exoid.recordings.tables.sheet import Column, Place

WRITTEN = (".csv", ".parquet")


def read_table(
    path: str | Path,
    columns: Mapping[str, str] | None = None,
    *,
    defaults: Sequence[Path] = (),
) -> tuple[Recording, Notes]:
    """The recording in NAME.csv and NAME.toml, and what its owner should be told.

    A missing NAME.toml means that nothing is known of subject, protocol and sensors. Unknown
    columns (as text) and keys are kept and named in the notes, with the known name they resemble.
    `columns` maps exoid's columns to those of a table in other words; [columns] in NAME.toml does
    the same. Such a table may also be of another format, and the notes say how it was understood.
    `defaults` are sidecars of many recordings, for where NAME.toml is silent.

    **Raises** `ValueError` (one line: file, line or key, what to do) for anything else.
    """
    path = Path(path)
    sidecar = path.with_suffix(".toml")
    if path == sidecar:
        raise ValueError(f"{path}: this is the sidecar. Name the .csv beside it.")
    chosen = {**columns_told(sidecar, defaults), **(columns or {})}
    tables, extra, key_notes = keys_told(
        sidecar,
        f"{sidecar}: there is none: of subject, protocol and sensors only what options say is "
        "known.",
        defaults,
    )
    with naming(path):
        rate, measured = tables["sensors"].sample_rate, tables["protocol"].measured
        named = named_columns(path, chosen, rate, measured=measured)
        built = build(named, judging(tables["subject"]))
    with naming(sidecar):  # what fails now, with all samples sound, fails by a key
        recording = built.described(tables | {"extra_tables": extra})
    notes = named.notes + built.notes + late_starts(recording)
    return recording, tuple(f"{path}: {note}" for note in notes) + key_notes


def named_columns(
    path: Path, chosen: Mapping[str, str], rate: float | None, *, measured: bool
) -> Named:
    """The columns of a table in exoid's own words, or of one in anybody else's."""
    if path.suffix.lower() not in TEXTS:
        return assemble(read_sheet(path, chosen.values()), chosen, rate, measured=measured)
    text = legible(path)
    if chosen or not is_own(text):
        return assemble(sheet_of_text(text), chosen, rate, measured=measured)
    columns, notes = parse_table(text)
    degrees = {
        IN_DEGREES[name]: f"{name}: read as degrees" for name in columns if name in IN_DEGREES
    }
    for own, name in [(IN_DEGREES[name], name) for name in columns if name in IN_DEGREES]:
        columns[own] = np.radians(columns.pop(name))
    return Named(columns, Place("line", FIRST_LINE), degrees, notes)


def write_table(recording: Recording, path: str | Path) -> None:
    """Writes NAME.csv or NAME.parquet, and NAME.toml, such that `load` gives back every number.

    Both are first written in full beside their targets and then moved into place: a failure
    leaves the files that were there as they were.

    >>> exoid.write_table(exoid.load("drops.csv").recording, "again.csv")
    >>> len(exoid.load("again.csv").recording.segments)
    2
    """
    path = Path(path)
    if path.suffix.lower() not in WRITTEN:
        raise ValueError(f"{path}: a recording is written to a name that ends in .csv or .parquet.")
    tables = (recording.subject, recording.protocol, recording.sensors)
    sidecar = sidecar_text(*tables, recording.extra_tables)
    columns = flat(recording.segments)
    check_names([*columns])
    samples = as_csv(columns) if path.suffix.lower() == ".csv" else parquet_of(columns)
    replace_files({path.with_suffix(".toml"): [sidecar], path: samples})


def parquet_of(columns: Mapping[str, Any]) -> bytes:
    require("pyarrow", "a Parquet file is written")
    from exoid.recordings.formats.parquet import as_parquet

    return as_parquet(columns)


def as_csv(columns: Mapping[str, Any]) -> list[str]:
    """The CSV: numbers as short as they are exact, missing samples empty."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(columns)
    cells = (
        Column("", each).texts if isinstance(each, np.ndarray) else each
        for each in columns.values()
    )
    writer.writerows(zip(*cells, strict=True))
    return [text.getvalue()]
