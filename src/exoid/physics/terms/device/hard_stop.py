"""A stop that the leg hits."""

import jax.numpy as jnp

from exoid.physics.moment import Moment
from exoid.physics.parameter import Parameter, parameter
from exoid.physics.term import Memory, PhysicsTerm, Scalar

INSIDE = 0.03  # rad, of the range of motion, where a search begins
FAR = (1.2, -3.2)  # rad, where no leg comes
SOFTEST = 0.4  # s of a bounce: gravity alone turns a leg round in half a second


class HardStop(PhysicsTerm):
    """tau = -max(0, k x + b x') where x = phi - phi_e > 0, and its mirror image below phi_f.

    k = J (pi / t_c)^2 and b = 2 zeta J pi / t_c, so that a bounce lasts about t_c.
    """

    title = "a stop that the leg hits"
    reference = "Hunt & Crossley, J Applied Mechanics 42(2), 1975"
    explanation = (
        "The leg or the exoskeleton runs against something: the hinge's own stop, a strap, the "
        "edge of the chair."
    )
    isolate = "movements that stay away from that angle, and some that reach it"
    substeps = 6
    jumps = True

    contact_time: Parameter = parameter("t_c", "s", 0.008, 0.8, "how long a bounce lasts", (0.03,))
    extension_angle: Parameter = parameter(
        "phi_e", "rad", -2.5, 1.2, "stop of extension", lambda low, high: (high - INSIDE, FAR[0])
    )
    flexion_angle: Parameter = parameter(
        "phi_f", "rad", -3.2, 0.5, "stop of flexion", lambda low, high: (FAR[1], low + INSIDE)
    )
    damping_ratio: Parameter = parameter("zeta", "1", 0.0, 2.0, "damping ratio of the stop", (0.3,))

    def itself(self) -> bool:
        """Does it stop the leg? What is softer than gravity only makes it stiffer."""
        return bool(self.contact_time < SOFTEST)

    def torque(self, now: Moment, memory: Memory) -> Scalar:
        how = now.place.slack, jnp.pi / self.contact_time, self.damping_ratio
        extension, flexion = (spring_and_damper(*gap, *how) for gap in self.gaps(now, memory))
        return now.inertia * (flexion - extension)

    def gaps(self, now: Moment, memory: Memory) -> tuple[tuple[Scalar, Scalar], ...]:
        extension = (self.extension_angle - now.angle, -now.angular_velocity)
        flexion = (now.angle - self.flexion_angle, now.angular_velocity)
        return extension, flexion


def spring_and_damper(
    gap: Parameter, opening: Parameter, slack: Parameter, rate: Parameter, ratio: Parameter
) -> Scalar:
    """What a closed contact of this natural `rate` [rad/s] and damping `ratio` pushes with over the
    inertia [rad/s^2]: it never pulls.
    """
    push = -(rate**2) * gap - 2 * ratio * rate * opening
    return jnp.where(gap < slack, jnp.maximum(push, 0.0), 0.0)
