"""A constant torque."""

from typing import Any

import jax.numpy as jnp

from exoid.physics.moment import Moment
from exoid.physics.parameter import Parameter, parameter
from exoid.physics.term import Memory, PhysicsTerm, Scalar


class TorqueBias(PhysicsTerm):
    """tau = tau_b: muscle tone, co-contraction, a preloaded spring."""

    title = "constant torque"
    reference = "De Groote et al., PLoS ONE 13(10), 2018: baseline tone"
    explanation = (
        "A steady torque acts all the time: muscles that do not relax, a rubber band, a cable."
    )
    isolate = "EMG, or drops after the instruction to relax; a known added mass"
    isolate_rig = "the hanging angle without and with a known added mass"
    isolate_driven = "slow movements both ways, and where the axis rests with the motor off"

    steady = True
    same_torque = "stiffness_rest_angle"

    bias: Parameter = parameter("tau_b", "N m", -50.0, 50.0, "constant torque", (0.3,))

    @staticmethod
    def as_same_torque(size: Any, stiffness: Any) -> Any:
        return size / stiffness

    def torque(self, now: Moment, memory: Memory) -> Scalar:
        return jnp.asarray(self.bias)
