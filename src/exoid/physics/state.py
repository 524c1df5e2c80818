"""The state of the leg."""

import equinox as eqx
from jaxtyping import Array, Float


class LegState(eqx.Module):
    """Angle and angular velocity of the shank, extension positive, 0 = shank horizontal.

    >>> float(exoid.LegState(jnp.radians(-20.0), jnp.asarray(0.0)).angular_velocity)  # rad/s
    0.0
    """

    angle: Float[Array, "*batch"]  # rad
    angular_velocity: Float[Array, "*batch"]  # rad/s
