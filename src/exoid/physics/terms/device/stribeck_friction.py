"""Dry friction that falls with speed."""

from typing import Any, ClassVar

import jax.numpy as jnp
from jaxtyping import Array, Float

from exoid.physics.moment import Moment
from exoid.physics.parameter import parameter
from exoid.physics.term import PhysicsTerm


class StribeckFriction(PhysicsTerm):
    """tau = -(F_c + F_x exp(-(phi'/v_s)^2)) sgn(phi'): more to break loose than to keep moving."""

    title: ClassVar[str] = "dry friction that falls with speed (Stribeck)"
    reference: ClassVar[str] = "Armstrong-Helouvry, Dupont, Canudas de Wit, Automatica 30(7), 1994"
    explanation: ClassVar[str] = (
        "The hinge grips at rest and in slow movement and lets go as it becomes faster, as "
        "lubricated or plastic bearings do."
    )
    isolate: ClassVar[str] = "slow movements and many turning points: drops from small angles"
    substeps: ClassVar[int] = 4  # it sticks and lets go within a step

    excess: Float[Any, ""] = parameter("F_x", "N m", 0.0, 50.0, "friction beyond F_c", (0.05,))
    level: Float[Any, ""] = parameter("F_c", "N m", 0.0, 50.0, "friction at speed", (0.03,))
    speed: Float[Any, ""] = parameter("v_s", "rad/s", 0.02, 3.0, "Stribeck speed", (0.1, 0.4, 1.2))

    def dry_friction(self, now: Moment) -> Float[Array, ""]:
        return self.level + self.excess * jnp.exp(-((now.angular_velocity / self.speed) ** 2))
