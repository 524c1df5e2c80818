"""How much encoder and gyro scatter."""

from typing import Any

import equinox as eqx
import jax.numpy as jnp
from jaxtyping import Array, Float


class SensorNoise(eqx.Module):
    """The variances of both, and from where on a sample is not believed."""

    angle: Float[Any, ""]  # rad^2
    angular_velocity: Float[Any, ""]  # (rad/s)^2
    wander: Float[Any, ""]  # s, by which the age of the gyro's sample scatters
    drift: Float[Any, ""]  # s in a second, by which the mean of that age does
    gate: Float[Any, ""]  # chi-square of a sample

    def white(self, variance: Float[Array, "2"]) -> Float[Array, "2"]:
        """Which share of it is: the age wanders like a sawtooth, which neighbours share."""
        return jnp.stack([jnp.ones(()), self.angular_velocity / variance[1]])

    def variance(self, acceleration: Float[Array, ""]) -> Float[Array, "2"]:
        """Of angle and rate, at an acceleration [rad/s^2]."""
        late = (self.wander * acceleration) ** 2
        return jnp.stack([jnp.asarray(self.angle), self.angular_velocity + late])
