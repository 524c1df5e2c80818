"""Are innovations white, as those of a model that explains the motion are?

With the whitened innovation v and the memory s <- rho s + v of those before it, v s has the mean 0
and the variance 1 / (1 - rho^2). What a model misses is slow beside a sample: neighbours share it,
and v s becomes positive on the average. No size of the sensors' noise does that.
"""

from typing import Any

import equinox as eqx
import jax.numpy as jnp
from jaxtyping import Array, Float

MEMORY = 0.9  # rho: ten samples
FADING = 1 - 1 / 150  # per sample: a window of 150
FEWEST = 30  # of these, before anything is said
LIMIT = 6.0  # standard deviations
POWER = 4.0  # mean square of an innovation from which on it is no noise of these sensors


class Whiteness(eqx.Module):
    """Are innovations white? Sums over a window that fades, of both filters' angle and rate."""

    memory: Float[Any, "2 2"]  # the innovations before, the latest most
    lagged: Float[Any, "2 2"]  # of each by the memory before it
    power: Float[Any, "2 2"]
    weight: Float[Any, ""]  # of the power
    squares: Float[Any, ""]  # of the weights of the lagged


def seen(white: Whiteness, whitened: Float[Array, "2 2"], used: Float[Array, "2 2"]) -> Whiteness:
    """With one more innovation of both filters."""
    memory = MEMORY * white.memory + whitened
    return Whiteness(
        memory=jnp.where(used > 0, memory, white.memory),
        lagged=FADING * white.lagged + whitened * white.memory,
        power=FADING * white.power + whitened**2,
        weight=FADING * white.weight + 1.0,
        squares=FADING**2 * white.squares + 1.0,
    )


def unwhite(white: Whiteness) -> Float[Array, "2"]:
    """Standard deviations by which the worse channel of each filter is away from white noise."""
    each = white.lagged * jnp.sqrt((1 - MEMORY**2) / jnp.maximum(white.squares, 1.0))
    return jnp.max(each, axis=1)


def fails(white: Whiteness) -> Float[Array, "2"]:
    """Does the model fail to explain what each filter saw?"""
    loud = jnp.max(white.power, axis=1) > POWER * jnp.maximum(white.weight, 1.0)
    return ((unwhite(white) > LIMIT) | loud) & (white.weight > FEWEST)


def nothing_seen() -> Whiteness:
    none = jnp.zeros((2, 2))
    return Whiteness(none, none, none, jnp.zeros(()), jnp.zeros(()))
