"""The passive moment of a knee near the ends of its range: a double exponential."""

import jax.numpy as jnp

from exoid.physics.moment import Moment
from exoid.physics.parameter import Parameter, parameter
from exoid.physics.term import Memory, PhysicsTerm, Scalar

BENT = -2.1  # rad, 120 deg of flexion: where the flexion moment is quoted


class EndRangeStiffening(PhysicsTerm):
    """tau = -M_e exp(phi/w_e) + M_f exp(-(phi - BENT)/w_f).

    M_e is the moment at full extension, M_f that at 120 deg of flexion; w_e and w_f are the angles
    over which they grow e-fold.
    """

    title = "stiffening towards the ends of the range"
    reference = "Riener & Edrich, J Biomech 32(5), 1999"
    explanation = (
        "Ligaments and stretched muscles resist steeply near full extension and deep flexion, "
        "where Eq. 9 has a straight spring."
    )
    isolate = "drops that reach both ends of the range, and the same with the back reclined"
    living = True

    extension: Parameter = parameter("M_e", "N m", 0.0, 30.0, "moment at full extension", (0.5,))
    extension_width: Parameter = parameter(
        "w_e", "rad", 0.04, 1.0, "e-fold angle of extension", (0.12, 0.3)
    )
    flexion: Parameter = parameter("M_f", "N m", 0.0, 30.0, "moment at 120 deg of flexion", (0.3,))
    flexion_width: Parameter = parameter("w_f", "rad", 0.04, 1.0, "e-fold angle of flexion", (0.2,))

    def torque(self, now: Moment, memory: Memory) -> Scalar:
        towards_extension = jnp.exp(now.angle / self.extension_width)
        towards_flexion = jnp.exp(-(now.angle - BENT) / self.flexion_width)
        return -self.extension * towards_extension + self.flexion * towards_flexion
