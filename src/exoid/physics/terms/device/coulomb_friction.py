"""Dry friction of constant level."""

import jax.numpy as jnp

from exoid.physics.moment import Moment
from exoid.physics.parameter import Parameter, parameter
from exoid.physics.term import PhysicsTerm, Scalar


class CoulombFriction(PhysicsTerm):
    """tau = -F_c sgn(phi') while moving; up to F_c against whatever pulls while at rest."""

    title = "dry friction (Coulomb)"
    reference = "Olsson et al., European Journal of Control 4(3), 1998"
    explanation = (
        "A constant torque opposes every movement and can end it short of rest, as in a clamped "
        "hinge or under tight straps."
    )
    isolate = "drops from a large and from a small angle, down to complete rest"
    isolate_driven = "constant speeds, slow and fast, both ways: dry friction takes as much of each"
    substeps = 2  # it turns over within a step

    level: Parameter = parameter("F_c", "N m", 0.0, 50.0, "friction level", (0.05,))

    def dry_friction(self, now: Moment) -> Scalar:
        return jnp.asarray(self.level)
