"""The cells of a table in exoid's own words, read to the letter: what is wrong is named by line."""

import csv
import io
import re
from collections import Counter

import numpy as np

from exoid.files.text_file import Notes, misquoted
from exoid.recordings.columns import IN_DEGREES, NUMERIC
from exoid.recordings.tables.assemble import kept, without_empty
from exoid.recordings.tables.sheet import Cells

NUMBER = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?", re.ASCII)
NOT_IN_NUMBERS = re.compile(r"[^0-9+\-.eE,\n]")  # no letters but e: `inf` is not read
MISSING = ("", "nan")  # what a cell without a number holds; NumPy and pandas write the second
FIRST_LINE = 2  # the line of the first sample; the header is line 1


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
