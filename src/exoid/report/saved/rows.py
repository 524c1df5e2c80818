"""Records that are alike, as the columns of a table, and back.

What a record within a row holds are columns FIELD.FIELD; a column FIELD then says where there is
one.
"""

from collections.abc import Mapping, Sequence
from typing import Any

from exoid.report.saved.node import Record, Values, holds

MOST = 40  # columns that can be looked at


def to_columns(rows: Sequence[Any]) -> dict[str, list[Any]] | None:
    """The cells of every column; None where the rows are not alike, or hold more than cells can."""
    first = rows[0]
    if not all(isinstance(row, Record) and row.keys() == first.keys() for row in rows):
        return None
    columns: dict[str, list[Any]] = {}
    for name in first:
        cells = [row[name] for row in rows]
        if holds(cells, Record):
            found = spread(name, cells)
        else:
            found = None if any(map(heavy, cells)) else {name: cells}
        if found is None:
            return None
        columns |= found
    return columns if 0 < len(columns) <= MOST else None


def spread(name: str, cells: Sequence[Any]) -> dict[str, list[Any]] | None:
    """The columns of what is a record, where it is one."""
    there = [cell is not None for cell in cells]
    inner = to_columns([cell for cell in cells if cell is not None])
    if inner is None:
        return None
    found: dict[str, list[Any]] = {} if all(there) else {name: list(there)}
    for field, known in inner.items():
        left = iter(known)
        found[f"{name}.{field}"] = [next(left) if one else None for one in there]
    return found


def heavy(cell: Any) -> bool:
    """Does a cell hold more than one number?"""
    return holds(cell, Values) and not (isinstance(cell, Values) and cell.bare)


def from_columns(columns: Mapping[str, list[Any]], count: int) -> list[dict[str, Any]]:
    """The rows that `to_columns` was given."""
    whole = {name: cells for name, cells in columns.items() if "." not in name}
    within: dict[str, dict[str, list[Any]]] = {}
    for name, cells in columns.items():
        outer, point, field = name.partition(".")
        if point:
            within.setdefault(outer, {})[field] = cells
    for name, inner in within.items():
        rows = from_columns(inner, count)
        there = whole.get(name, [True] * count)
        whole[name] = [row if one else None for row, one in zip(rows, there, strict=True)]
    return [{name: cells[row] for name, cells in whole.items()} for row in range(count)]
