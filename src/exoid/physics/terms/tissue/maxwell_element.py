"""A spring and a damper in series: tissue that relaxes."""

from typing import Any, ClassVar

import jax.numpy as jnp
from jaxtyping import Array, Float

from exoid.physics.moment import Moment
from exoid.physics.parameter import parameter
from exoid.physics.term import Memory, PhysicsTerm


class MaxwellElement(PhysicsTerm):
    """tau = -k_1 (phi - z),  z' = (phi - z) / t_r. Its memory is phi - z."""

    title: ClassVar[str] = "tissue that relaxes (Maxwell element)"
    reference: ClassVar[str] = "Fung, Biomechanics: Mechanical Properties of Living Tissues, 1993"
    explanation: ClassVar[str] = (
        "Tendon and muscle resist a quick stretch and give way to a lasting one, so that stiffness "
        "and damping depend on how fast the leg swings."
    )
    isolate: ClassVar[str] = "holds of 1, 10 and 60 s before the release; swings at two periods"
    living: ClassVar[bool] = True
    memory_size: ClassVar[int] = 1
    lasting: ClassVar[bool] = True

    stiffness: Float[Any, ""] = parameter(
        "k_1", "N m/rad", 0.0, 30.0, "stiffness of the element", (0.5,)
    )
    relaxation_time: Float[Any, ""] = parameter(
        "t_r", "s", 0.02, 10.0, "relaxation time", (0.08, 0.4, 2.0)
    )

    def torque(self, now: Moment, memory: Memory) -> Float[Array, ""]:
        return -self.stiffness * memory[0]

    def memory_at_rest(self, now: Moment) -> Memory:
        return jnp.zeros(1)

    def memory_rate(self, now: Moment, memory: Memory) -> Memory:
        return (now.angular_velocity - memory[0] / self.relaxation_time)[None]
