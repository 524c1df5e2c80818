"""Dry friction that falls with speed."""

import jax.numpy as jnp

from exoid.physics.moment import Moment
from exoid.physics.parameter import Parameter, parameter
from exoid.physics.term import PhysicsTerm, Scalar


class StribeckFriction(PhysicsTerm):
    """tau = -(F_c + F_x exp(-(phi'/v_s)^2)) sgn(phi'): more to break loose than to keep moving."""

    title = "dry friction that falls with speed (Stribeck)"
    reference = "Armstrong-Helouvry, Dupont, Canudas de Wit, Automatica 30(7), 1994"
    explanation = (
        "The hinge grips at rest and in slow movement and lets go as it becomes faster, as "
        "lubricated or plastic bearings do."
    )
    isolate = "slow movements and many turning points: drops from small angles"
    isolate_driven = "constant speeds both ways, down to the slowest"
    substeps = 4  # it sticks and lets go within a step

    excess: Parameter = parameter("F_x", "N m", 0.0, 50.0, "friction beyond F_c", (0.05,))
    level: Parameter = parameter("F_c", "N m", 0.0, 50.0, "friction at speed", (0.03,))
    speed: Parameter = parameter("v_s", "rad/s", 0.02, 3.0, "Stribeck speed", (0.1, 0.4, 1.2))

    def dry_friction(self, now: Moment) -> Scalar:
        return self.level + self.excess * jnp.exp(-((now.angular_velocity / self.speed) ** 2))
