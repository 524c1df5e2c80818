"""Binary tables as libraries of another hand read them: calamine, DuckDB and c3d.

Only the container is read a second time: what its rows mean is said by exoid in both.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from exoid.recordings.formats.c3d import analog_columns, point_columns, thinned
from exoid.recordings.formats.excel import cell_of, squared
from exoid.recordings.tables.arrays import columns_of
from exoid.recordings.tables.layout import is_number, sheet_of_rows
from exoid.recordings.tables.sheet import Column, Place, Sheet

from .reading import Rows, Sample, Unread
from .tables import numbers_of

MEMORY = "500MB"
NUMBERS = ("TINYINT", "SMALLINT", "INTEGER", "BIGINT", "HUGEINT", "U", "FLOAT", "DOUBLE")


def rows_by_calamine(path: Path, _sample: Sample) -> Rows:
    """The first sheet with two rows of numbers."""
    with panics():
        from python_calamine import CalamineWorkbook

        book = CalamineWorkbook.from_path(path)
        sheets = [book.get_sheet_by_name(name) for name in book.sheet_names]
        found = [sheet.to_python(skip_empty_area=False) for sheet in sheets]
    for rows in found:
        cells = [[cell_of(None if cell == "" else cell) for cell in row] for row in rows]
        if sum(any(map(is_number, row)) for row in cells) > 1:
            return numbers_of(sheet_of_rows(squared(cells), Place("row", 1)))
    raise ValueError("no rows of numbers")


@contextmanager
def panics() -> Iterator[None]:
    """What Rust throws is no `Exception`."""
    try:
        yield
    except BaseException as fault:
        if type(fault).__name__ != "PanicException":
            raise
        raise Unread(str(fault)) from fault


def columns_by_duckdb(path: Path, _sample: Sample) -> Rows:
    """Every flat column as exoid has it: numbers, NaN where one is missing, or words."""
    table = database().execute("SELECT * FROM read_parquet(?)", [str(path)])
    names, kinds = zip(*[each[:2] for each in table.description], strict=True)
    cells = zip(*table.fetchall(), strict=True)
    columns = [
        column
        for name, kind, each in zip(names, kinds, cells, strict=True)
        for column in columns_of(name, flat_array(str(kind), each))
    ]
    return numbers_of(Sheet(tuple(columns), Place("row")))


@cache
def database() -> Any:
    """A connection of this process."""
    import duckdb

    return duckdb.connect(config={"threads": 1, "memory_limit": MEMORY})


def flat_array(kind: str, cells: tuple) -> np.ndarray:
    if kind.startswith(NUMBERS):
        return np.array([np.nan if each is None else each for each in cells], np.float64)
    if kind == "VARCHAR":
        return np.array(["" if each is None else each for each in cells], str)
    raise Unread(kind)


def channels_by_c3d(path: Path, _sample: Sample) -> Rows:
    """Points, and what analog channels have at their frames."""
    import c3d

    with path.open("rb") as file:
        reader = c3d.Reader(file)
        frames = [*reader.read_frames(check_nan=False)]
    points, raw = np.array([points for _, points, _ in frames]), samples(path, reader, len(frames))
    width = 4 * reader.point_used
    invalid = raw[:, 3:width:4] < 0  # c3d takes what is between -1 and 0 for 0
    places = np.where(invalid[:, :, None], np.nan, points[:, :, :3]).astype(np.float64)
    held = {
        "points": places.transpose(2, 1, 0),
        "analogs": analogs(reader, raw[:, width:].reshape(-1, reader.analog_used).T),
        "point_labels": np.array(reader.point_labels),
        "analog_labels": np.array(reader.analog_labels),
        "angles": np.zeros(0, str),
        "point_units": np.array(["mm", "deg"]),
        "analog_units": np.zeros(0, str),
    }
    columns: list[Column] = point_columns(held)
    if held["analogs"].size:
        columns += thinned(analog_columns(held), len(frames))
    return numbers_of(Sheet(tuple(columns), Place("frame")))


def samples(path: Path, reader: Any, frames: int) -> np.ndarray:
    """As they stand in the file, a row for every frame."""
    if reader.point_scale > 0:
        raise Unread("samples that are integers")
    begin = (reader.header.data_block - 1) * 512
    count = frames * (4 * reader.point_used + reader.analog_used * reader.analog_per_frame)
    return np.frombuffer(path.read_bytes(), "<f4", count, begin).reshape(frames, -1)


def analogs(reader: Any, raw: np.ndarray) -> np.ndarray:
    """As ezc3d rounds, and c3d does not: offsets go in single precision, scales in double."""
    scale, scales, offsets = reader.get_analog_transform_parameters()
    above = raw - np.asarray(offsets, np.float32)[:, None]
    return above.astype(np.float64) * np.asarray(scales, np.float64)[:, None] * float(scale)
