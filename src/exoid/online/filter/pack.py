"""Trees of many numbers as few arrays.

A loop or a branch of a compiled program copies every array that goes through it, at a tenth of a
microsecond or more each, however small. A belief has thirty numbers that stand by themselves.
"""

from collections.abc import Callable
from typing import Any, TypeVar

import jax
import jax.numpy as jnp
import numpy as np

SMALL = 16  # numbers of an array that goes into the row
Tree = TypeVar("Tree")


class Form:
    """The shapes of a tree, by which it becomes a row and large arrays, and comes back."""

    def __init__(self, like: Any, small: int = SMALL):
        leaves, self.structure = jax.tree.flatten(like)
        self.leaves = [jax.ShapeDtypeStruct(jnp.shape(leaf), jnp.result_type(leaf)) for leaf in leaves]
        self.into_row = [leaf.size <= small for leaf in self.leaves]
        sizes = [leaf.size for leaf, row in zip(self.leaves, self.into_row, strict=True) if row]
        self.cuts = np.cumsum(sizes)[:-1].tolist()

    def packed(self, tree: Any) -> tuple[Any, ...]:
        """The row, and the large arrays behind it."""
        each = list(zip(jax.tree.leaves(tree), self.into_row, strict=True))
        row = [jnp.ravel(jnp.asarray(leaf, float)) for leaf, goes in each if goes]
        return (jnp.concatenate(row), *(leaf for leaf, goes in each if not goes))

    def unpacked(self, arrays: tuple[Any, ...]) -> Any:
        """`packed` undone; whole numbers survive, as a double holds them."""
        small, large = iter(jnp.split(arrays[0], self.cuts)), iter(arrays[1:])
        leaves = [
            next(small).reshape(leaf.shape).astype(leaf.dtype) if goes else next(large)
            for leaf, goes in zip(self.leaves, self.into_row, strict=True)
        ]
        return jax.tree.unflatten(self.structure, leaves)


def where_so(condition: Any, then: Callable[[Tree], Tree], tree: Tree) -> Tree:
    """`then` of the tree where the condition holds, else the tree; only the one is computed."""
    form = Form(tree)

    def so(arrays):
        return form.packed(then(form.unpacked(arrays)))

    return form.unpacked(jax.lax.cond(condition, so, lambda arrays: arrays, form.packed(tree)))


def as_long_as(
    condition: Callable[[Tree], Any], then: Callable[[Tree], Tree], tree: Tree
) -> Tree:
    """`then` again and again, while the condition holds."""
    form = Form(tree)

    def holds(arrays):
        return condition(form.unpacked(arrays))

    def again(arrays):
        return form.packed(then(form.unpacked(arrays)))

    return form.unpacked(jax.lax.while_loop(holds, again, form.packed(tree)))
