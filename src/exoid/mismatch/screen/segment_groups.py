"""Segments in groups of one size, so that one compiled program serves every number of them."""

from collections.abc import Callable, Iterable
from typing import Any, TypeVar

import jax
import numpy as np
from jaxtyping import Float, Int

from exoid.fitting.solve.cores.side_by_side import side_by_side

Tree = TypeVar("Tree")
Batch = TypeVar("Batch")


def of_all_segments(
    task: Callable[[Batch, np.ndarray], Any],
    batches: Iterable[Batch],
    segments: int,
    size: int,
    axis: int = 0,
) -> list[Any]:
    """`task(batch, rows)` of every batch, on all cores: for groups of `size` segments, the last of
    which the last segment fills, joined along an axis.
    """
    waiting = list(batches)
    groups = [
        np.minimum(np.arange(first, first + size), segments - 1)
        for first in range(0, segments, size)
    ]
    each = [(batch, rows) for rows in groups for batch in waiting]
    found = side_by_side(lambda one: task(*one), each)

    def joined(*leaves: np.ndarray) -> np.ndarray:
        return np.take(np.concatenate(leaves, axis), np.arange(segments), axis)

    count = len(waiting)
    return [jax.tree.map(joined, *found[number::count]) for number in range(count)]


def of(rows: np.ndarray, tree: Tree, axis: int = 0) -> Tree:
    """The segments in these rows of every leaf."""
    return jax.tree.map(lambda leaf: np.take(leaf, rows, axis), tree)


def summed(
    tables: np.ndarray, places: Int[np.ndarray, "segment own"], first: int
) -> Float[np.ndarray, "row column"]:
    """One table of all segments' products: the first rows and columns of each stand at its
    `places`, the others from `first` on.
    """
    height, width = (first + size - places.shape[1] for size in tables[0].shape)
    whole = np.zeros((height, width))
    for table, place in zip(tables, places, strict=True):
        whole[np.ix_([*place, *range(first, height)], [*place, *range(first, width)])] += table
    return whole
