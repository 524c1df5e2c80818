"""Rows that a logger wrote twice."""

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

Cells = np.ndarray | tuple[str, ...]
Columns = Mapping[str, Cells]


def stamped_again(columns: Columns) -> NDArray[np.bool_]:
    """Which rows have the time and the segment of the row before."""
    again = repeats(columns["time_s"]) & ~np.isnan(np.asarray(columns["time_s"], dtype=float))
    return again & repeats(columns["segment"]) if "segment" in columns else again


def doubled(columns: Columns) -> NDArray[np.bool_]:
    """Which rows are the one before once more, cell by cell; none where rows of one time differ,
    for its times were rounded.
    """
    again = stamped_again(columns)
    if not again.any():
        return again
    alike = np.logical_and.reduce([repeats(cells) for cells in columns.values()])
    return again if (alike | ~again).all() else np.zeros(again.size, dtype=bool)


def repeats(cells: Cells) -> NDArray[np.bool_]:
    """Which cells say what the one before says; two empty ones do."""
    each = np.asarray(cells)
    same = each[1:] == each[:-1]
    if each.dtype.kind == "f":
        same |= np.isnan(each[1:]) & np.isnan(each[:-1])
    return np.concatenate([np.zeros(1, dtype=bool), same])
