"""Drag that grows with the square of speed."""

from typing import Any, ClassVar

import jax.numpy as jnp
from jaxtyping import Array, Float

from exoid.physics.moment import Moment
from exoid.physics.parameter import parameter
from exoid.physics.term import Memory, PhysicsTerm


class QuadraticDrag(PhysicsTerm):
    """tau = -b phi' |phi'|."""

    title: ClassVar[str] = "drag that grows with the square of speed"
    reference: ClassVar[str] = "Lin & Rymer, IEEE TBME 38(9), 1991: damping rises with amplitude"
    explanation: ClassVar[str] = (
        "Fast movement is damped more than in proportion, by tissue that moves along (or a sail: "
        "air on a bare leg is a hundred times too thin)."
    )
    isolate: ClassVar[str] = "drops from large and small angles: damping that goes with amplitude"

    coefficient: Float[Any, ""] = parameter(
        "b", "N m s^2/rad^2", 0.0, 2.0, "drag coefficient", (0.02,)
    )

    def torque(self, now: Moment, memory: Memory) -> Float[Array, ""]:
        return -self.coefficient * now.angular_velocity * jnp.abs(now.angular_velocity)
