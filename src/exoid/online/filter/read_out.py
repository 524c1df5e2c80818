"""From what is followed to what a leg is: m l g / J, c / J and d / J.

The offset o is followed as if nothing were known of it. But gravity tells gamma = B / A, and the
seat is level but for its tilt e: o - c gamma = c e. That is a measurement of 0 with the variance
(c / J)^2 var(e), no line in the unknowns; so it is taken anew at every reading, where the filter
stands, and never becomes a part of what is followed.
"""

from typing import Any

import jax
import jax.numpy as jnp
from jaxtyping import Array, Bool, Float

from exoid.online.filter.gaussian import Gaussian
from exoid.online.filter.times import times
from exoid.online.model.unknowns import AT, Row

ROUNDS = 3  # of Gauss-Newton; the last moves nothing
FAR = 5.0  # standard deviations from the seat, which no level lets it be tilted by
LEAST = 1e-3  # 1/s^2, of a torque over inertia that nobody could see

Scalar = Float[Array, ""]


def on_the_seat(belief: Gaussian, tilt: Any) -> Gaussian:
    """The belief with what is known of the seat, whose tilt [rad] has this standard deviation."""

    def corrected(_, found: Gaussian) -> Gaussian:
        value, slope, noise = slope_of_seat(found.mean, tilt)
        factor = times(slope[None], belief.root)[0]
        total = jnp.sum(factor**2) + noise
        gain = times(belief.root, factor[:, None])[:, 0] / total
        left = value + jnp.sum(slope * (belief.mean - found.mean))
        mean = belief.mean - gain * left
        narrower = jnp.outer(gain, factor) / (1 + jnp.sqrt(noise / total))
        return Gaussian(mean, belief.root - narrower)

    return jax.lax.fori_loop(0, ROUNDS, corrected, belief)


def off_the_seat(belief: Gaussian, tilt: Any) -> Bool[Array, ""]:
    """Do the drops contradict what is known of the seat? Then the spring rests elsewhere, or a
    constant torque acts, and the ratios that the seat makes sure of are wrong.
    """
    value, slope, noise = slope_of_seat(belief.mean, tilt)
    total = jnp.sum(times(slope[None], belief.root) ** 2) + noise
    return value**2 > FAR**2 * total


def slope_of_seat(mean: Row, tilt: Any) -> tuple[Scalar, Row, Scalar]:
    """o - c gamma, its derivative by the row, and the variance that a tilt gives it."""

    def tilted(row: Row) -> Scalar:
        turned = row[AT["upright_gravity"]] / row[AT["level_gravity"]]
        return row[AT["offset"]] - row[AT["stiffness"]] * turned

    value, slope = jax.value_and_grad(tilted)(mean)
    return value, slope, (mean[AT["stiffness"]] * tilt) ** 2 + LEAST**2


def ratios(belief: Gaussian) -> tuple[Float[Array, "3"], Float[Array, "3"]]:
    """m l g / J, c / J and d / J, and their standard errors."""
    errors = jnp.sqrt(jnp.sum(times(slopes(belief.mean), belief.root) ** 2, axis=1))
    return values(belief.mean), errors


def values(row: Row) -> Float[Array, "3"]:
    gravity = jnp.hypot(row[AT["level_gravity"]], row[AT["upright_gravity"]])
    return jnp.stack([gravity, row[AT["stiffness"]], row[AT["damping"]]])


def slopes(row: Row) -> Float[Array, "3 unknown"]:
    """The derivatives of the ratios by the row."""
    return jax.jacfwd(values)(jnp.asarray(row))
