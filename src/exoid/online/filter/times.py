"""Products of small matrices as sums, which XLA puts into one kernel with what is around them."""

from typing import Any

import jax.numpy as jnp
from jaxtyping import Array, Float


def times(
    one: Float[Any, "row inner"], other: Float[Any, "inner column"]
) -> Float[Array, "row column"]:
    """The matrix `one` times the matrix `other`."""
    return jnp.sum(one[:, :, None] * other[None], axis=1)
