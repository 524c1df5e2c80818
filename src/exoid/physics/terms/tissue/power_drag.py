"""Drag that grows with another power of speed than its square."""

import jax.numpy as jnp

from exoid.physics.moment import Moment
from exoid.physics.parameter import Parameter, parameter
from exoid.physics.term import Memory, PhysicsTerm, Scalar
from exoid.physics.terms.tissue.quadratic_drag import QuadraticDrag

SLOW = 1e-3  # rad/s, below which it is in proportion to the rate
VISCOUS = 1.25  # power below which it is hardly more than damping


class PowerDrag(PhysicsTerm):
    """tau = -b phi' |phi'|^(p - 1), |phi'| in rad/s, p between that of damping and a cube."""

    title = "drag that grows with a power of speed"
    reference = QuadraticDrag.reference
    explanation = (
        "Fast movement is damped more than in proportion, by a power of speed that is not its "
        "square."
    )
    isolate = QuadraticDrag.isolate
    isolate_driven = QuadraticDrag.isolate_driven
    by_whole_drops = True

    coefficient: Parameter = parameter("b", "N m s^2/rad^2", 0.0, 2.0, "drag at 1 rad/s", (0.02,))
    power: Parameter = parameter("p", "1", 1.2, 3.0, "power of speed", (1.5,), plain=2.0)

    def itself(self) -> bool:
        return bool(self.power >= VISCOUS)

    def torque(self, now: Moment, memory: Memory) -> Scalar:
        rate = now.angular_velocity
        grown = jnp.exp((self.power - 1) * jnp.log(rate**2 + SLOW**2) / 2)
        return -self.coefficient * rate * grown
