"""Parquet, by pyarrow: columns as any data frame writes them, and exoid's own table as columns."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from exoid.files.foreign import Arrays, read_apart
from exoid.recordings.formats.packed import packed, unpacked
from exoid.recordings.tables.arrays import columns_of
from exoid.recordings.tables.sheet import Place, Sheet

INDEX = "__index_level_"  # pandas' numbers of rows


def read_parquet(path: Path) -> Sheet:
    """The columns of numbers, dates and words."""
    arrays = unpacked(read_apart(columns, path, "Write it again.", library="pyarrow.parquet"))
    found = [column for name, each in arrays.items() for column in columns_of(name, each)]
    if not found:
        raise ValueError("holds no column of numbers with two rows or more.")
    return Sheet(tuple(found), Place("row"))


def columns(path: Path) -> Arrays:
    """Every flat column as an array; in a process of its own."""
    import pyarrow.parquet

    table = pyarrow.parquet.read_table(path, page_checksum_verification=True)
    names = [name for name in dict.fromkeys(table.column_names) if not name.startswith(INDEX)]
    return packed({name: as_array(table.column(name)) for name in names})


def as_array(column: Any) -> np.ndarray:
    """Numbers, NaN where one is missing, or words; empty for anything else."""
    import pyarrow
    from pyarrow import types

    kind = column.type
    if types.is_nested(kind):
        return np.empty(0)
    if types.is_null(kind):
        return np.full(len(column), np.nan)
    if types.is_integer(kind) or types.is_floating(kind) or types.is_decimal(kind):
        numbers = column.cast(pyarrow.float64()).to_numpy(zero_copy_only=False)
        return np.asarray(numbers, np.float64)
    if types.is_duration(kind):
        return column.to_numpy(zero_copy_only=False)
    return np.array([word_of(each) for each in column.to_pylist()], str)


def word_of(cell: Any) -> str:
    """Empty where there is none; bytes are text that was not declared as such."""
    if isinstance(cell, bytes):
        return cell.decode("utf-8", errors="replace")
    return "" if cell is None else str(cell)


def as_parquet(columns: Mapping[str, Any]) -> bytes:
    """Columns of numbers and of words, as the content of a file."""
    import pyarrow
    import pyarrow.parquet

    table = pyarrow.table({name: pyarrow.array(cells) for name, cells in columns.items()})
    content = pyarrow.BufferOutputStream()
    pyarrow.parquet.write_table(table, content, write_page_checksum=True)
    return content.getvalue().to_pybytes()
