"""From what is followed to what a leg is: m l g / J, c / J and d / J.

The offset o is followed as if nothing were known of it. But gravity tells gamma = B / A, and the
seat is level but for its tilt e: o - c gamma = c e. That is a measurement of 0 with the variance
(c / J)^2 var(e), no line in the unknowns; so it is taken anew at every reading, where the filter
stands, and never becomes a part of what is followed.
"""

import jax
import jax.numpy as jnp
from jaxtyping import Array, Float

from exoid.online.filter.gaussian import Gaussian
from exoid.online.model.unknowns import AT, Row

ROUNDS = 3  # of Gauss-Newton; the last moves nothing


def on_the_seat(belief: Gaussian, tilt: float) -> Gaussian:
    """The belief with what is known of the seat, whose tilt [rad] has this standard deviation."""
    start = belief.mean

    def tilted(row: Row) -> Float[Array, ""]:
        turned = row[AT["upright_gravity"]] / row[AT["level_gravity"]]
        return row[AT["offset"]] - row[AT["stiffness"]] * turned

    def corrected(_, found):
        value, slope = jax.value_and_grad(tilted)(found.mean)
        factor = slope @ belief.root
        # A spring of nothing says nothing of the seat: then neither does the seat of the spring.
        noise = (jnp.abs(found.mean[AT["stiffness"]]) * tilt) ** 2 + LEAST**2
        total = jnp.sum(factor**2) + noise
        gain = belief.root @ factor / total
        mean = start - gain * (value + slope @ (start - found.mean))
        return Gaussian(mean, belief.root - jnp.outer(gain, factor) / (1 + jnp.sqrt(noise / total)))

    return jax.lax.fori_loop(0, ROUNDS, corrected, belief)


LEAST = 1e-3  # 1/s^2, of a torque over inertia that nobody could see


def ratios(belief: Gaussian) -> tuple[Float[Array, "3"], Float[Array, "3"]]:
    """m l g / J, c / J and d / J, and their standard errors."""
    level, upright = belief.mean[AT["level_gravity"]], belief.mean[AT["upright_gravity"]]
    gravity = jnp.hypot(level, upright)
    pair = belief.root[jnp.array([AT["level_gravity"], AT["upright_gravity"]])]
    along = (level * pair[0] + upright * pair[1]) / gravity
    others = belief.root[jnp.array([AT["stiffness"], AT["damping"]])]
    rows = jnp.concatenate([along[None], others])
    values = jnp.stack([gravity, belief.mean[AT["stiffness"]], belief.mean[AT["damping"]]])
    return values, jnp.sqrt(jnp.sum(rows**2, axis=1))
