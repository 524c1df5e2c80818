"""A recording on disk, format version 1: the samples in NAME.csv, what is known in NAME.toml.

Columns and keys are those that `recording.py` declares; this file holds no second list of them.
A table in exoid's own words is read to the letter; one in another's is understood in `tables/`.
"""

import csv
import io
import re
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from exoid.files.extras import require
from exoid.files.replacing import replace_files
from exoid.files.text_file import Notes, misquoted, naming
from exoid.recordings.columns import CHANNELS, IN_DEGREES, NUMERIC
from exoid.recordings.conventions.file_clock import SINCE
from exoid.recordings.defaults import columns_told, keys_told
from exoid.recordings.flat_table import flat
from exoid.recordings.formats.delimited import is_own, legible, sheet_of_text
from exoid.recordings.formats.sheets import TEXTS, read_sheet
from exoid.recordings.recording import BadSample, Recording, Segment, Subject
from exoid.recordings.selection import entries
from exoid.recordings.sidecar import sidecar_text
from exoid.recordings.tables.assemble import Named, assemble, kept, without_empty
from exoid.recordings.tables.sheet import Cells, Column, Place
from exoid.recordings.tables.sound_segments import Sound, sound

NUMBER = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?", re.ASCII)
NOT_IN_NUMBERS = re.compile(r"[^0-9+\-.eE,\n]")  # no letters but e: `inf` is not read
MISSING = ("", "nan")  # what a cell without a number holds; NumPy and pandas write the second
WRITTEN = (".csv", ".parquet")
FIRST_LINE = 2  # the line of the first sample; the header is line 1


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
        f"{sidecar} does not exist: of subject, protocol and sensors only what options say is "
        "known.",
        defaults,
    )
    with naming(path):
        named = named_columns(path, chosen, tables["sensors"].sample_rate)
        built = build(named, Subject(kind=tables["subject"].kind))
    with naming(sidecar):  # what fails now, with all samples sound, fails by a key
        recording = built.described(tables | {"extra_tables": extra})
    notes = named.notes + built.notes + late_starts(recording)
    return recording, tuple(f"{path}: {note}" for note in notes) + key_notes


def named_columns(path: Path, chosen: Mapping[str, str], rate: float | None) -> Named:
    """The columns of a table in exoid's own words, or of one in anybody else's."""
    if path.suffix.lower() not in TEXTS:
        return assemble(read_sheet(path, chosen.values()), chosen, rate)
    text = legible(path)
    if chosen or not is_own(text):
        return assemble(sheet_of_text(text), chosen, rate)
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
    columns = flat(recording)
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


def parse_table(text: str) -> tuple[dict[str, Cells], Notes]:
    """The columns by their name in the file: known ones as numbers, unknown ones as text."""
    first, _, body = text.partition("\n")
    names = header(first)
    body = body.rstrip("\n")
    check_lines(body)
    unknown = [name for name in names if name not in NUMERIC]
    plain = not unknown and not NOT_IN_NUMBERS.search(body)
    columns = (parse_numbers(names, body) if plain else None) or parse_cells(names, body)
    notes: list[str] = []
    columns = without_empty(columns, notes)
    return columns, (*notes, *kept(unknown))


def header(line: str) -> list[str]:
    """The names of the columns, refused where they cannot be a recording's."""
    try:
        names = [name.strip() for name in next(csv.reader([line], skipinitialspace=True))]
    except csv.Error as error:
        raise ValueError(f"line 1: {misquoted(error)}") from error
    check_names(names)
    return names


def check_names(names: list[str]) -> None:
    if "" in names:
        raise ValueError(
            f"column {names.index('') + 1} has no name. Delete it (pandas: to_csv(index=False))."
        )
    if twice := [name for name, count in Counter(names).items() if count > 1]:
        raise ValueError(f"column {twice[0]} is there twice. Delete or rename one.")
    if both := [name for name in names if IN_DEGREES.get(name) in names]:
        raise ValueError(f"{both[0]} and {IN_DEGREES[both[0]]} are the same quantity. Keep one.")
    found = f" The first line holds: {', '.join(names)[:200]}."
    if "time_s" not in names:
        raise ValueError(f"has no column time_s.{found} Name the time in seconds time_s.")
    if not {"angle_rad", "raw_angle_rad", "angle_deg", "raw_angle_deg"} & {*names}:
        raise ValueError(f"has no angle.{found} Give angle_rad or raw_angle_rad (or _deg).")


def check_lines(body: str) -> None:
    if not body.strip():
        raise ValueError("holds a header but no samples.")
    gap = 0 if body.startswith("\n") else body.find("\n\n") + 1
    if gap or body.startswith("\n"):
        line = FIRST_LINE + body.count("\n", 0, gap)
        raise ValueError(f"line {line} is empty. Delete it, so that every line is one sample.")


def parse_numbers(names: list[str], body: str) -> dict[str, Cells] | None:
    """All cells as numbers, NaN where a cell is empty, by NumPy's parser in C; None where it
    cannot read them.
    """
    filled = f"\n{body}\n"
    for gap, missing in ((",,", ",nan,"), (",,", ",nan,"), ("\n,", "\nnan,"), (",\n", ",nan\n")):
        filled = filled.replace(gap, missing) if gap in filled else filled
    try:
        table = np.loadtxt(filled[1:-1].split("\n"), delimiter=",", comments=None, ndmin=2)
        return dict(zip(names, table.T, strict=True))
    except ValueError:
        return None


def parse_cells(names: list[str], body: str) -> dict[str, Cells]:
    """The same line by line, for a file with text or spaces in it, or with a bad line, which is
    named.
    """
    reader, rows = csv.reader(io.StringIO(body), strict=True), []
    try:
        for row in reader:
            if problem := bad_row(names, row):
                raise ValueError(f"line {reader.line_num + FIRST_LINE - 1}{problem}")
            rows.append(row)
    except csv.Error as error:
        line = reader.line_num + FIRST_LINE - 1
        raise ValueError(f"line {line}: {misquoted(error)}") from error
    return {
        name: np.array([np.nan if missing(cell) else float(cell) for cell in cells])
        if name in NUMERIC
        else cells
        for name, cells in zip(names, zip(*rows, strict=True), strict=True)
    }


def missing(cell: str) -> bool:
    return cell.strip(" ").lower() in MISSING


def bad_row(names: list[str], row: list[str]) -> str | None:
    if len(row) != len(names):
        return (
            f" has {len(row)} cells, but the header names {len(names)} columns. "
            "Is a cell missing, is the file cut here (then delete this line), or are there decimal "
            "commas?"
        )
    for name, cell in zip(names, row, strict=True):
        if name in NUMERIC and not (NUMBER.fullmatch(cell.strip(" ")) or missing(cell)):
            return (
                f", column {name}: {cell[:40]!r} is not a number. "
                "Leave the cell empty where a sample is missing."
            )
    return None


def segment_starts(columns: Mapping[str, Cells], place: Place) -> np.ndarray:
    """The row at which each segment begins; without a column `segment` there is one."""
    if "segment" not in columns:
        return np.zeros(1, int)
    number = np.asarray(columns["segment"])
    starts = np.concatenate([[0], np.flatnonzero(np.diff(number) != 0) + 1])
    wrong = np.flatnonzero(number[starts] != np.arange(starts.size))
    if wrong.size:
        at = int(starts[wrong[0]])
        value = "empty" if np.isnan(number[at]) else f"{number[at]:g}"
        raise ValueError(
            f"{place(at)}, column segment: {value}, where {wrong[0]}"
            f"{f' or {wrong[0] - 1}' if wrong[0] else ''} is expected. Segments count 0, 1, 2, ... "
            "and the rows of each stand together: renumber or sort them."
        )
    return starts


@dataclass(frozen=True, eq=False)
class Built:
    """The samples of a table as a recording, and which of its segments they are."""

    samples: Recording
    kept: Sound

    @property
    def notes(self) -> Notes:
        return self.kept.notes

    def described(self, told: Mapping[str, Any]) -> Recording:
        """With what is told of it; of lists with an entry for each segment, those of the kept."""
        tables = dict(told)
        for name in {"subject", "protocol"} & tables.keys():
            tables[name] = entries(tables[name], self.kept.numbers, self.kept.count)
        return replace(self.samples, **tables)


def build(named: Named, subject: Subject) -> Built:
    """The samples, checked by the recording's own rules; a bad one is named by its line as well."""
    columns = named.columns
    starts = segment_starts(columns, named.place)
    stops = [*starts[1:], len(columns["time_s"])]
    segments = [cut(columns, slice(*rows)) for rows in zip(starts, stops, strict=True)]
    kept = sound(segments)
    try:
        return Built(Recording(tuple(segments[n] for n in kept.numbers), subject), kept)
    except BadSample as error:
        place = named.place(int(starts[kept.numbers[error.segment]]) + error.sample)
        words = [source for own, source in named.sources.items() if str(error).startswith(own)]
        hint = f" ({', '.join(words)}.)" if words else ""
        raise ValueError(f"{place}: {error}{hint}") from error


def late_starts(recording: Recording) -> Notes:
    """A clock that runs on from segment to segment: read as it is, and said."""
    late = [n for n, each in enumerate(recording.segments) if 0 != each.time[0] < SINCE]
    if not late:
        return ()
    start = recording.segments[late[0]].time[0]
    return (f"time_s starts at {start:g} s, not at 0, in segment {late[0]}. It is kept as it is.",)


def cut(columns: Mapping[str, Cells], rows: slice) -> Segment:
    """One segment. A channel that is empty throughout it was not measured in it."""
    cells = {name: each[rows] for name, each in columns.items()}
    channels: dict[str, Any] = {
        field: np.array(cells[name])
        for name, field in CHANNELS.items()
        if name in cells and (name == "time_s" or not np.isnan(np.asarray(cells[name])).all())
    }
    extra = {name: tuple(each) for name, each in cells.items() if name not in NUMERIC}
    return Segment(**channels, extra_columns=extra)
