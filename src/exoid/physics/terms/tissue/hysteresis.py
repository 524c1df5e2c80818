"""Hysteresis that does not depend on speed (Bouc-Wen)."""

from typing import Any, ClassVar

import jax.numpy as jnp
from jaxtyping import Array, Float

from exoid.physics.moment import Moment
from exoid.physics.parameter import parameter
from exoid.physics.term import Memory, PhysicsTerm


class Hysteresis(PhysicsTerm):
    """tau = -F z,  z' = (phi' - (|phi'| z + phi' |z|) / 2) / phi_y."""

    title: ClassVar[str] = "hysteresis (short-range stiffness, Bouc-Wen)"
    reference: ClassVar[str] = "Wen, J Eng Mech Div 102(2), 1976; De Groote et al., PLoS ONE, 2018"
    explanation: ClassVar[str] = (
        "The joint is stiff for the first degrees of every reversal and then yields, as cross-"
        "bridges, straps and pre-sliding bearings do."
    )
    isolate: ClassVar[str] = "small reversals, and a drop right after the leg was shaken"
    memory_size: ClassVar[int] = 1
    lasting: ClassVar[bool] = True
    substeps: ClassVar[int] = 4

    level: Float[Any, ""] = parameter("F", "N m", 0.0, 50.0, "torque after yielding", (0.1,))
    yield_angle: Float[Any, ""] = parameter("phi_y", "rad", 0.004, 0.6, "yield angle", (0.03, 0.15))

    def torque(self, now: Moment, memory: Memory) -> Float[Array, ""]:
        return -self.level * memory[0]

    def memory_rate(self, now: Moment, memory: Memory) -> Memory:
        velocity, z = now.angular_velocity, memory[0]
        yielding = (jnp.abs(velocity) * z + velocity * jnp.abs(z)) / 2
        return ((velocity - yielding) / self.yield_angle)[None]

    def memory_within(self, now: Moment, memory: Memory) -> Memory:
        return jnp.clip(memory, -1.0, 1.0)
