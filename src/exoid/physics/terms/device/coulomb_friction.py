"""Dry friction of constant level."""

from typing import Any, ClassVar

import jax.numpy as jnp
from jaxtyping import Array, Float

from exoid.physics.moment import Moment
from exoid.physics.parameter import parameter
from exoid.physics.term import PhysicsTerm


class CoulombFriction(PhysicsTerm):
    """tau = -F_c sgn(phi') while moving; up to F_c against whatever pulls while at rest."""

    title: ClassVar[str] = "dry friction (Coulomb)"
    reference: ClassVar[str] = "Olsson et al., European Journal of Control 4(3), 1998"
    explanation: ClassVar[str] = (
        "A constant torque opposes every movement and can end it short of rest, as in a clamped "
        "hinge or under tight straps."
    )
    isolate: ClassVar[str] = "drops from a large and from a small angle, down to complete rest"
    substeps: ClassVar[int] = 4  # it sticks and lets go within a step

    level: Float[Any, ""] = parameter("F_c", "N m", 0.0, 50.0, "friction level", (0.05,))

    def dry_friction(self, now: Moment) -> Float[Array, ""]:
        return jnp.asarray(self.level)
