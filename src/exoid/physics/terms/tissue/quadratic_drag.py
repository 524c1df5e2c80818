"""Drag that grows with the square of speed."""

import jax.numpy as jnp

from exoid.physics.moment import Moment
from exoid.physics.parameter import Parameter, parameter
from exoid.physics.term import Memory, PhysicsTerm, Scalar


class QuadraticDrag(PhysicsTerm):
    """tau = -b phi' |phi'|."""

    title = "drag that grows with the square of speed"
    reference = "Lin & Rymer, IEEE TBME 38(9), 1991: damping rises with amplitude"
    explanation = (
        "Fast movement is damped more than in proportion: of a leg by tissue that moves along (air "
        "on a bare one is a hundred times too thin), of a rig by a sail or a paddle."
    )
    isolate = "drops from large and small angles: damping that goes with amplitude"
    isolate_driven = "constant speeds, up to the fastest"

    coefficient: Parameter = parameter("b", "N m s^2/rad^2", 0.0, 2.0, "drag coefficient", (0.02,))

    def torque(self, now: Moment, memory: Memory) -> Scalar:
        return -self.coefficient * now.angular_velocity * jnp.abs(now.angular_velocity)
