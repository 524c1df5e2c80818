"""A constant torque."""

from typing import Any, ClassVar

import jax.numpy as jnp
from jaxtyping import Array, Float

from exoid.physics.moment import Moment
from exoid.physics.parameter import parameter
from exoid.physics.term import Memory, PhysicsTerm


class TorqueBias(PhysicsTerm):
    """tau = tau_b: muscle tone, co-contraction, a preloaded spring."""

    title: ClassVar[str] = "constant torque"
    reference: ClassVar[str] = "De Groote et al., PLoS ONE 13(10), 2018: baseline tone"
    explanation: ClassVar[str] = (
        "A steady torque acts all the time: muscles that do not relax, a rubber band, a cable."
    )
    isolate: ClassVar[str] = "EMG, or drops after the instruction to relax; a known added mass"

    bias: Float[Any, ""] = parameter("tau_b", "N m", -50.0, 50.0, "constant torque", (0.3,))

    def torque(self, now: Moment, memory: Memory) -> Float[Array, ""]:
        return jnp.asarray(self.bias)
