"""A triangle of which one unknown wanders."""

from typing import Any

import jax.numpy as jnp
from jaxtyping import Array, Float


def loosened(
    root: Float[Any, "unknown unknown"], at: int, deviation: Any
) -> Float[Array, "unknown unknown"]:
    """The triangle of a belief in which one unknown has the variance `deviation`^2 more.

    The columns from there on are rotated against the new one, one after the other.
    """
    corner = root[at:, at:]
    rest = jnp.zeros(corner.shape[0]).at[0].set(deviation)
    columns = []
    for number, column in enumerate(corner.T):
        own, new = column[number], rest[number]
        length = jnp.sqrt(own**2 + new**2)
        columns.append((own * column + new * rest) / length)
        rest = (own * rest - new * column) / length
    return jnp.concatenate(
        [root[:at], jnp.concatenate([root[at:, :at], jnp.stack(columns, axis=1)], axis=1)]
    )
