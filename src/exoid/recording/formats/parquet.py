"""Parquet, by pyarrow: columns as any data frame writes them, and exoid's own table as columns."""

from pathlib import Path
from typing import Any

import numpy as np

from exoid.recording.tables.arrays import cells_of
from exoid.recording.tables.sheet import Column, Place, Sheet, printable
from exoid.recording.tables.units import parted

INDEX = "__index_level_"  # pandas' numbers of rows


def read_parquet(path: Path) -> Sheet:
    """The columns of numbers, dates and words."""
    import pyarrow.parquet

    table = pyarrow.parquet.read_table(path)
    columns = [column_of(name, table.column(name)) for name in dict.fromkeys(table.column_names)]
    found = tuple(each for each in columns if each is not None)
    if not found:
        raise ValueError("holds no column of numbers with two rows or more.")
    return Sheet(found, Place("row"))


def column_of(name: str, column: Any) -> Column | None:
    """A column as numbers, NaN where one is missing, or as words; None for anything else."""
    import pyarrow

    kind = column.type
    if name.startswith(INDEX) or pyarrow.types.is_nested(kind):
        return None
    numeric = pyarrow.types.is_integer(kind) or pyarrow.types.is_floating(kind)
    if numeric or pyarrow.types.is_boolean(kind) or pyarrow.types.is_decimal(kind):
        numbers = column.cast(pyarrow.float64()).to_numpy(zero_copy_only=False)
        return Column(printable(name), np.asarray(numbers, np.float64), parted(name)[1])
    if pyarrow.types.is_null(kind):
        return Column(printable(name), np.full(len(column), np.nan))
    cells = cells_of(np.array(column.cast(pyarrow.string()).to_pylist(), dtype=object))
    return None if cells is None else Column(printable(name), cells, parted(name)[1])


def as_parquet(columns: dict[str, Any]) -> bytes:
    """Columns of numbers and of words, as the content of a file."""
    import pyarrow
    import pyarrow.parquet

    table = pyarrow.table({name: pyarrow.array(cells) for name, cells in columns.items()})
    content = pyarrow.BufferOutputStream()
    pyarrow.parquet.write_table(table, content)
    return content.getvalue().to_pybytes()
