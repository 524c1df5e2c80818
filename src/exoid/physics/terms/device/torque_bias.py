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

    same_torque: ClassVar[str] = "stiffness_rest_angle"

    bias: Float[Any, ""] = parameter("tau_b", "N m", -50.0, 50.0, "constant torque", (0.3,))

    @staticmethod
    def as_same_torque(size: Any, stiffness: Any) -> Any:
        return size / stiffness

    def torque(self, now: Moment, memory: Memory) -> Float[Array, ""]:
        return jnp.asarray(self.bias)
