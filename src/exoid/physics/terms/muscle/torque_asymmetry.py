"""A voluntary torque that is larger in one half of the cycle."""

from typing import Any, ClassVar

import jax.numpy as jnp
from jaxtyping import Array, Float

from exoid.physics.moment import Moment
from exoid.physics.parameter import parameter
from exoid.physics.term import Memory, PhysicsTerm


class TorqueAsymmetry(PhysicsTerm):
    """tau_h of Eq. 10 times 1 + a in the second half of the cycle."""

    title: ClassVar[str] = "a voluntary torque larger in one half of the cycle"
    reference: ClassVar[str] = "Eq. 10 of the paper assumes both halves alike"
    explanation: ClassVar[str] = (
        "The person pushes harder on the way up than on the way down, or the other way round."
    )
    isolate: ClassVar[str] = "passive drops for the leg, then the cycle by inverse dynamics"
    voluntary: ClassVar[bool] = True

    asymmetry: Float[Any, ""] = parameter("a", "1", -0.9, 3.0, "excess of the second half", (0.1,))

    def torque(self, now: Moment, memory: Memory) -> Float[Array, ""]:
        cycle = now.place.cycle
        second = jnp.where(now.time - cycle.onset > cycle.period / 2, 1.0, 0.0)
        return self.asymmetry * second * cycle.torque(now.time)
