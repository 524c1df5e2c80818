"""Trees of many numbers as few arrays.

A loop or a branch of a compiled program copies every array that goes through it, at a tenth of a
microsecond or more each, however small. A belief has thirty numbers that stand by themselves.
"""

from collections.abc import Callable
from typing import Any, TypeVar

import jax
import jax.extend.core
import jax.numpy as jnp
import numpy as np

SMALL = 16  # numbers of an array that goes into the row
Tree = TypeVar("Tree")


class Form:
    """The shapes of a tree, by which it becomes a row and large arrays, and comes back."""

    def __init__(self, like: Any, small: int | None = SMALL):
        leaves, self.structure = jax.tree.flatten(like)
        self.leaves = [
            jax.ShapeDtypeStruct(jnp.shape(leaf), jnp.result_type(leaf)) for leaf in leaves
        ]
        self.into_row = [small is None or leaf.size <= small for leaf in self.leaves]
        sizes = [leaf.size for leaf, row in zip(self.leaves, self.into_row, strict=True) if row]
        ends = np.cumsum(sizes).tolist()
        self.parts = list(zip([0, *ends[:-1]], ends, strict=True))

    def packed(self, tree: Any) -> tuple[Any, ...]:
        """The row, and the large arrays behind it."""
        each = list(zip(jax.tree.leaves(tree), self.into_row, strict=True))
        row = [jnp.ravel(jnp.asarray(leaf, float)) for leaf, goes in each if goes]
        return (jnp.concatenate(row), *(leaf for leaf, goes in each if not goes))

    def unpacked(self, arrays: tuple[Any, ...]) -> Any:
        """`packed` undone; whole numbers survive, as a double holds them."""
        small = (arrays[0][first:last] for first, last in self.parts)
        large = iter(arrays[1:])
        leaves = [
            next(small).reshape(leaf.shape).astype(leaf.dtype) if goes else next(large)
            for leaf, goes in zip(self.leaves, self.into_row, strict=True)
        ]
        return jax.tree.unflatten(self.structure, leaves)


def where_so(condition: Any, then: Callable[[Tree], Tree], tree: Tree) -> Tree:
    """`then` of the tree where the condition holds, else the tree; only the one is computed."""
    moved = Moved(then, tree)

    def so(arrays):
        return moved.after(arrays)

    before = moved.form.packed(moved.part_of(tree))
    return moved.whole(jax.lax.cond(condition, so, lambda arrays: arrays, before))


def as_long_as(condition: Callable[[Tree], Any], then: Callable[[Tree], Tree], tree: Tree) -> Tree:
    """`then` again and again, while the condition holds."""
    moved = Moved(then, tree)

    def holds(arrays):
        return condition(moved.whole(arrays))

    before = moved.form.packed(moved.part_of(tree))
    return moved.whole(jax.lax.while_loop(holds, moved.after, before))


class Moved:
    """What of a tree a function changes: only that goes through the loop or the branch."""

    def __init__(self, then: Callable[[Any], Any], tree: Any):
        self.leaves, self.structure = jax.tree.flatten(tree)
        self.leaves = [jnp.asarray(leaf) for leaf in self.leaves]
        traced = jax.make_jaxpr(then)(jax.tree.unflatten(self.structure, self.leaves))
        known = dict(zip(map(id, traced.jaxpr.invars), range(len(self.leaves)), strict=True))
        same = [known.get(id(out)) == at for at, out in enumerate(traced.jaxpr.outvars)]
        self.changes = [not each for each in same]
        self.run = jax.extend.core.jaxpr_as_fun(traced)
        self.form = Form(self.part_of(tree))

    def part_of(self, tree: Any) -> list[Any]:
        """The leaves that change."""
        each = zip(jax.tree.leaves(tree), self.changes, strict=True)
        return [leaf for leaf, moves in each if moves]

    def whole(self, arrays: tuple[Any, ...]) -> Any:
        """The tree with the leaves that changed."""
        new = iter(self.form.unpacked(arrays))
        each = zip(self.leaves, self.changes, strict=True)
        leaves = [next(new) if moves else leaf for leaf, moves in each]
        return jax.tree.unflatten(self.structure, leaves)

    def after(self, arrays: tuple[Any, ...]) -> tuple[Any, ...]:
        """What changed, once more."""
        leaves = jax.tree.leaves(self.whole(arrays))
        after = self.run(*leaves)
        return self.form.packed(self.part_of(jax.tree.unflatten(self.structure, after)))
