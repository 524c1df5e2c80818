"""The knee's axis moves as it bends."""

import jax.numpy as jnp

from exoid.physics.moment import Moment
from exoid.physics.parameter import Parameter, parameter
from exoid.physics.term import Memory, PhysicsTerm, Scalar

STEEPER = 1.6  # J changes by more than l: part of it goes with the square


class PolycentricAxis(PhysicsTerm):
    """m l g (1 + e u), J (1 + 1.6 e u) with u = -phi / (pi/2), and -J'(phi) phi'^2 / 2."""

    title = "a knee axis that moves as the knee bends"
    reference = "Iwaki, Pinskerova & Freeman, J Bone Joint Surg B 82(8), 2000"
    explanation = (
        "Femur and tibia roll on each other, so that the leg's weight hangs nearer to or farther "
        "from the hinge the more the knee is bent."
    )
    isolate = "drops with a known added mass, whose distance is known"
    living = True
    inertial = True

    change: Parameter = parameter("e", "1", -0.35, 0.35, "change over 90 deg", (0.05, -0.05))

    def torque(self, now: Moment, memory: Memory) -> Scalar:
        bent = -now.angle / (jnp.pi / 2)
        heavier = 1 + STEEPER * self.change * bent
        weight = now.gravity * self.change * bent * jnp.cos(now.tilted)
        slope = -STEEPER * self.change * now.inertia / (jnp.pi / 2)
        turned = now.inertia * now.angular_acceleration
        pushed = turned - weight - slope * now.angular_velocity**2 / 2
        return pushed / heavier - turned
