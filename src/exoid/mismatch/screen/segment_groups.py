"""Segments in groups of one size, so that one compiled program serves every number of them."""

from collections.abc import Iterator
from typing import TypeVar

import jax
import numpy as np

Tree = TypeVar("Tree")


def grouped(tree: Tree, size: int, axis: int = 0) -> Iterator[Tree]:
    """Parts of `size` segments along an axis of every leaf; the last one fills the last part."""
    count = jax.tree.leaves(tree)[0].shape[axis]
    for first in range(0, count, size):
        rows = np.minimum(np.arange(first, first + size), count - 1)
        yield jax.tree.map(lambda leaf, rows=rows: np.take(leaf, rows, axis=axis), tree)
