"""A stop that the leg hits."""

from typing import Any, ClassVar

import jax.numpy as jnp
from jaxtyping import Array, Float

from exoid.physics.moment import Moment
from exoid.physics.parameter import parameter
from exoid.physics.term import Memory, PhysicsTerm

HANGING = -jnp.pi / 2  # a stop above is one of extension, below it one of flexion
INSIDE = 0.03  # rad, of the range, where a search begins


class HardStop(PhysicsTerm):
    """tau = -max(0, k x + b x') where x = phi - phi_s > 0 (of flexion: the mirror image).

    k = J (pi / t_c)^2 and b = 2 zeta J pi / t_c, so that a bounce lasts about t_c.
    """

    title: ClassVar[str] = "a stop that the leg hits"
    reference: ClassVar[str] = "Hunt & Crossley, J Applied Mechanics 42(2), 1975"
    explanation: ClassVar[str] = (
        "The leg or the exoskeleton runs against something: the hinge's own stop, a strap, the "
        "edge of the chair."
    )
    isolate: ClassVar[str] = "movements that stay away from that angle, and some that reach it"
    substeps: ClassVar[int] = 8

    contact_time: Float[Any, ""] = parameter(
        "t_c", "s", 0.008, 0.4, "how long a bounce lasts", (0.02, 0.1)
    )
    angle: Float[Any, ""] = parameter(
        "phi_s",
        "rad",
        -3.0,
        1.0,
        "angle of the stop",
        lambda low, high: (high - INSIDE, low + INSIDE),
    )
    damping_ratio: Float[Any, ""] = parameter("zeta", "1", 0.0, 2.0, "its damping ratio", (0.3,))

    def torque(self, now: Moment, memory: Memory) -> Float[Array, ""]:
        side = jnp.where(self.angle > HANGING, 1.0, -1.0)
        depth = side * (now.angle - self.angle)
        rate = jnp.pi / self.contact_time
        push = rate**2 * depth + 2 * self.damping_ratio * rate * side * now.angular_velocity
        return -side * now.inertia * jnp.where(depth > 0, jnp.maximum(push, 0.0), 0.0)
