"""Are innovations white, as those of a model that explains the motion are?

With the whitened innovation v and the memory s <- rho s + v of those before it, v s has the mean 0
and, given what was before, the variance s^2: sum(v s) / sqrt(sum(s^2)) is of a martingale, near a
standard normal. What a model misses is slow beside a sample: neighbours share it, and v s becomes
positive on the average. No size of the sensors' noise does that.
"""

from typing import Any

import equinox as eqx
import jax.numpy as jnp
from jaxtyping import Array, Bool, Float

MEMORY = 0.9  # rho: ten samples
FADING = 1 - 1 / 150  # per sample: a window of 150
FEWEST = 30  # of these, before anything is said
LIMIT = 5.5  # standard deviations
POWER = 4.0  # mean square of an innovation from which on it is no noise of these sensors


class Whiteness(eqx.Module):
    """Are innovations white? Sums over a window that fades, of both filters' angle and rate."""

    memory: Float[Any, "2 2"]  # the innovations before, the latest most
    lagged: Float[Any, "2 2"]  # of each by the memory before it
    squares: Float[Any, "2 2"]  # the variance of that where they are white
    power: Float[Any, "2 2"]
    weight: Float[Any, ""]  # of the power


Table = Float[Array, "2 2"]


def seen(white: Whiteness, whitened: Table, used: Bool[Array, "2 2"], share: Table) -> Whiteness:
    """With one more innovation of both filters, that counts for the share that is surely white."""
    counted = share * whitened
    memory = MEMORY * white.memory + counted
    varies = (share * white.memory) ** 2
    return Whiteness(
        memory=jnp.where(used, memory, white.memory),
        lagged=FADING * white.lagged + counted * white.memory,
        squares=FADING**2 * white.squares + jnp.where(used, varies, 0.0),
        power=FADING * white.power + whitened**2,
        weight=FADING * white.weight + 1.0,
    )


def unwhite(white: Whiteness) -> Float[Array, "2"]:
    """Standard deviations by which the worse channel of each filter is away from white noise."""
    least = FEWEST / (1 - MEMORY**2)
    return jnp.max(white.lagged / jnp.sqrt(jnp.maximum(white.squares, least)), axis=1)


def judged(white: Whiteness) -> Bool[Array, ""]:
    """Were there enough samples for a model to fail by?"""
    return white.weight > FEWEST


def fails(white: Whiteness) -> Bool[Array, "2"]:
    """Does the model fail to explain what each filter saw?"""
    loud = jnp.max(white.power, axis=1) > POWER * jnp.maximum(white.weight, 1.0)
    return ((unwhite(white) > LIMIT) | loud) & judged(white)


def nothing_seen() -> Whiteness:
    none = jnp.zeros((2, 2))
    return Whiteness(none, none, none, none, jnp.zeros(()))
