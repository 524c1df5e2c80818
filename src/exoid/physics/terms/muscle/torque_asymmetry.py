"""A voluntary torque that is larger in one half of the cycle."""

import jax.numpy as jnp

from exoid.physics.moment import Moment
from exoid.physics.parameter import Parameter, parameter
from exoid.physics.term import Memory, PhysicsTerm, Scalar


class TorqueAsymmetry(PhysicsTerm):
    """tau_h of Eq. 10 times 1 + a in the second half of the cycle."""

    title = "a voluntary torque larger in one half of the cycle"
    reference = "Eq. 10 of the paper assumes both halves alike"
    explanation = (
        "The person pushes harder on the way up than on the way down, or the other way round."
    )
    isolate = "passive drops for the leg, then the cycle by inverse dynamics"
    voluntary = True

    asymmetry: Parameter = parameter("a", "1", -0.9, 3.0, "excess of the second half", (0.1,))

    def torque(self, now: Moment, memory: Memory) -> Scalar:
        cycle = now.place.cycle
        second = jnp.where(now.time - cycle.onset > cycle.period / 2, 1.0, 0.0)
        return self.asymmetry * second * cycle.torque(now.time)
