"""Dry friction that grows with what a gear has to carry."""

import jax.numpy as jnp

from exoid.physics.moment import Moment
from exoid.physics.parameter import Parameter, parameter
from exoid.physics.term import PhysicsTerm, Scalar


class LoadFriction(PhysicsTerm):
    """tau = -(F_c + mu |m l g cos(phi) + c phi|) sgn(phi'): teeth that carry a load rub more."""

    title = "dry friction that grows with load"
    reference = (
        "Duclusaud et al., Extended friction models for the physics simulation of servo actuators, "
        "2024"
    )
    explanation = (
        "A gear rubs the more, the more weight its teeth carry: it holds an arm far from the "
        "vertical and lets it swing near it. Rubber or wire rope that loses the more the farther "
        "it is bent looks alike."
    )
    isolate = "the same drops without and with a known added mass"
    isolate_driven = "the same movement without and with a known load"
    substeps = 2  # it turns over within a step
    mechanical = True

    share: Parameter = parameter("mu", "1", 0.0, 2.0, "share of the load", (0.1, 0.4))
    level: Parameter = parameter("F_c", "N m", 0.0, 50.0, "friction without load", (0.03,))

    def dry_friction(self, now: Moment) -> Scalar:
        load = now.gravity * jnp.cos(now.tilted) + now.stiffness * now.angle
        return self.level + self.share * jnp.abs(load)
