"""Recordings with something missing in them, and a library small enough to compile quickly."""

from typing import Any, ClassVar

import jax
import jax.numpy as jnp
import numpy as np
from jaxtyping import Array, Float

from exoid.physics.leg import LegModel
from exoid.physics.moment import Moment
from exoid.physics.parameter import parameter
from exoid.physics.sensing.gyro_scale import GyroScale
from exoid.physics.term import Memory, PhysicsTerm
from exoid.physics.terms.coulomb_friction import CoulombFriction
from exoid.physics.terms.maxwell_element import MaxwellElement
from exoid.physics.terms.quadratic_drag import QuadraticDrag
from exoid.physics.torque import NoTorque
from exoid.twin.motion import Movement
from exoid.twin.protocols import record
from fit_cases import BODY, leg

SMALL = (CoulombFriction, GyroScale, MaxwellElement, QuadraticDrag)
DROPS = (
    Movement(np.radians(-10), 2.4),
    Movement(np.radians(-30), 2.4),
    Movement(np.radians(-45), 2.4),
)
FRICTION = CoulombFriction(jnp.asarray(0.08))


class Detent(PhysicsTerm):
    """tau = a sin(8 phi): a term of a user's own."""

    title: ClassVar[str] = "detent"
    reference: ClassVar[str] = "a test"
    explanation: ClassVar[str] = "The hinge catches at regular angles."
    isolate: ClassVar[str] = "slow movements"

    size: Float[Any, ""] = parameter("a", "N m", -5.0, 5.0, "size", (0.1,))

    def torque(self, now: Moment, memory: Memory) -> Float[Array, ""]:
        return self.size * jnp.sin(8 * now.angle)


class Broken(PhysicsTerm):
    """A term whose derivative is not finite: sqrt of what is zero."""

    title: ClassVar[str] = "broken"
    reference: ClassVar[str] = "a test"
    explanation: ClassVar[str] = "It cannot be differentiated."
    isolate: ClassVar[str] = "none"

    size: Float[Any, ""] = parameter("a", "N m", -5.0, 5.0, "size", (0.0,))

    def torque(self, now: Moment, memory: Memory) -> Float[Array, ""]:
        return jnp.sqrt(jnp.abs(self.size)) * now.angle


def session(*terms, movements=DROPS, seed=0):
    """Drops, or whatever movements, of a leg that has these terms, through sensors and filter."""
    model = LegModel(leg(), NoTorque(), terms=terms)
    return record(model, movements, jax.random.key(seed), subject=BODY)
