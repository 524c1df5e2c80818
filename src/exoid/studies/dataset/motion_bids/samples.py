"""The samples of a motion file: columns without a header, which its channels name."""

from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from exoid.files.text_file import naming, read_text
from exoid.recordings.columns import NUMERIC
from exoid.recordings.tables.assemble import in_numbers
from exoid.recordings.tables.sheet import Cells, Column, Place
from exoid.studies.dataset.motion_bids.channels import LATENCY
from exoid.studies.dataset.motion_bids.labels import inherited
from exoid.studies.dataset.tables.cells import Row, rows_of
from exoid.studies.dataset.tables.tsv import MISSING

TAB = "\t"
NUMBERS = {LATENCY, *NUMERIC}


@dataclass(frozen=True, eq=False)
class Channels:
    """The rows of `_channels.tsv`, and the samples of each under its name and unit."""

    rows: list[dict[str, str]]
    columns: list[Column]


def read_channels(path: Path) -> Channels:
    """The channels of a motion file. **Raises** `ValueError` in one line."""
    tables = inherited(path, "_channels.tsv")
    if not tables:
        raise ValueError(f"{path}: no _channels.tsv beside it names its columns. Add it.")
    with naming(tables[-1]):
        rows = [checked(row) for row in rows_of(tables[-1])]
    names = [row["name"] for row in rows]
    with naming(path):
        cells = read_columns(read_text(path), names)
    units = ["" if row.get("units") == MISSING else row.get("units", "") for row in rows]
    return Channels(rows, [Column(*each) for each in zip(names, cells, units, strict=True)])


def checked(row: Row) -> dict[str, str]:
    if missing := [each for each in ("name", "type") if not row.cells.get(each)]:
        raise ValueError(f"{row.place} has no {missing[0]}. BIDS wants one for each channel.")
    return row.cells


def read_columns(text: str, names: list[str]) -> list[Cells]:
    """exoid's own columns as numbers, NaN where one is missing; others as their words."""
    lines = text.strip("\n").split("\n")
    if lines == [""]:
        raise ValueError("holds no samples.")
    for number, line in enumerate(lines, 1):
        if line.count("\t") + 1 != len(names):
            raise ValueError(
                f"line {number} has {len(line.split(TAB))} cells, but _channels.tsv names "
                f"{len(names)} channels. Is the file cut here, or is a channel missing?"
            )
    if {*names} <= NUMBERS:
        with suppress(ValueError):  # NumPy's parser in C; a bad cell is named below
            filled = [line.replace(MISSING, "nan") for line in lines]
            return [*np.loadtxt(filled, delimiter=TAB, comments=None, ndmin=2).T]
    cells = zip(*(line.split(TAB) for line in lines), strict=True)
    return [words_or_numbers(name, each) for name, each in zip(names, cells, strict=True)]


def words_or_numbers(name: str, cells: tuple[str, ...]) -> Cells:
    texts = tuple("" if each == MISSING else each for each in cells)
    return in_numbers(Column(name, texts), Place("line", 1)) if name in NUMBERS else texts
