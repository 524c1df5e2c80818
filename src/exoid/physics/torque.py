"""What drives the leg: nothing, the voluntary cycle of Eq. 10, or a measured torque."""

from abc import abstractmethod

import equinox as eqx
import jax.numpy as jnp
from jaxtyping import Array, Float

from exoid.physics.parameter import parameter
from exoid.physics.waves import cycle_shape


class Torque(eqx.Module):
    """A torque on the knee that depends on time alone, extension positive."""

    @abstractmethod
    def __call__(self, time: Float[Array, "*time"]) -> Float[Array, "*time"]:
        """The torque at `time` [N m]."""


class NoTorque(Torque):
    """tau_h = 0: a relaxed leg, or an unpowered rig.

    >>> float(exoid.NoTorque()(jnp.asarray(0.5)))  # N m
    0.0
    """

    def __call__(self, time: Float[Array, "*time"]) -> Float[Array, "*time"]:
        return jnp.zeros_like(time)


class CycleTorque(Torque):
    """Eq. 10: tau_h = -tau sin(2 pi f t) up to half the period T, +tau sin(2 pi f t) after it.

    With f = 1/T this is -tau |sin(2 pi t / T)|, of one sign throughout, as the paper's words have
    it; its Eq. 4 says f = 2/T, which gives four lobes of mean zero. Both are time-symmetric.

    >>> torque = exoid.CycleTorque(*map(jnp.asarray, (-9.5, 1.8, 1 / 1.8, 0.0)))  # N m, s, Hz, s
    >>> round(float(torque(jnp.asarray(0.45))), 2)  # N m, a quarter of the period after its onset
    9.5
    """

    amplitude: Float[Array, ""] = parameter("tau", "N m", -250.0, 250.0, "torque amplitude")
    period: Float[Array, ""] = parameter("T", "s", 0.05, 120.0, "cycle period")
    frequency: Float[Array, ""] = parameter("f", "Hz", 0.0, 40.0, "torque frequency")
    onset: Float[Array, ""] = parameter("t0", "s", 0.0, 1e4, "start of the cycle's clock")

    def __call__(self, time: Float[Array, "*time"]) -> Float[Array, "*time"]:
        return self.amplitude * cycle_shape(time - self.onset, self.period, self.frequency)


class MeasuredTorque(Torque):
    """A torque that was measured at `time`, linear between its samples.

    >>> torque = exoid.MeasuredTorque(time=jnp.array([0.0, 1.0]), torque=jnp.array([0.0, 3.0]))
    >>> float(torque(jnp.asarray(0.5)))  # N m
    1.5
    """

    time: Float[Array, " samples"]  # s
    torque: Float[Array, " samples"]  # N m

    def __call__(self, time: Float[Array, "*time"]) -> Float[Array, "*time"]:
        return jnp.interp(time, self.time, self.torque)
