"""Soft tissue that swings on the bone."""

import jax.numpy as jnp
from jaxtyping import Array, Float

from exoid.physics.leg import GRAVITY
from exoid.physics.moment import Moment
from exoid.physics.parameter import Parameter, parameter
from exoid.physics.term import Memory, PhysicsTerm, Scalar

SLUGGISH = 0.9  # damping ratio from which on tissue rings no more


class WobblingMass(PhysicsTerm):
    """A mass mu at the distance r from the knee, tied to the bone by springs along and across it.

    It stands x across the shank and y along it away from its place; with w = 2 pi f, p = r + y,

        x'' + p phi'' = x phi'^2 - 2 y' phi' - g cos(phi) - w^2 x - 2 zeta w x' = X,
        y'' - x phi'' = p phi'^2 + 2 x' phi' - g sin(phi) - w^2 y - 2 zeta w y' = Y,
        (J - mu r^2) phi'' = (Eq. 9) - mu (g (y cos(phi) - x sin(phi)) + p X - x Y)
                             - 2 mu (p y' + x x') phi'.

    The share beta = mu r / (m l) says how large mu is. Its memory is (x, y, x', y').
    """

    title = "soft tissue that wobbles on the bone"
    reference = "Nikooyan & Zadpoor, Proc IMechE H 225(12), 2011"
    explanation = (
        "Calf muscle and skin follow the bone with a delay and ring after it, which a rigid leg "
        "cannot."
    )
    isolate = "a movement that is stopped abruptly, with a gyro above 100 Hz"
    living = True
    inertial = True
    memory_size = 4
    substeps = 2

    share: Parameter = parameter("beta", "1", 0.0, 0.5, "share of the weight", (0.15,))
    radius: Parameter = parameter(
        "r", "m", 0.08, 0.45, "distance of the tissue from the knee", (0.22,)
    )
    frequency: Parameter = parameter("f", "Hz", 1.2, 10.0, "wobbling frequency", (3.0, 6.0))
    damping_ratio: Parameter = parameter(
        "zeta", "1", 0.02, 1.0, "damping ratio of the tissue", (0.2,)
    )

    def itself(self) -> bool:
        """Does it ring? What creeps behind the bone is tissue that relaxes."""
        return bool(self.damping_ratio < SLUGGISH)

    def accelerations(self, now: Moment, memory: Memory) -> Float[Array, "3"]:
        """phi'', x'' and y''."""
        x, y, x_rate, y_rate = memory
        rate, turn = 2 * jnp.pi * self.frequency, now.angular_velocity
        damping, away = 2 * self.damping_ratio * rate, self.radius + y
        level, upright = GRAVITY * jnp.cos(now.tilted), GRAVITY * jnp.sin(now.tilted)
        across = x * turn**2 - 2 * y_rate * turn - level - rate**2 * x - damping * x_rate
        along = away * turn**2 + 2 * x_rate * turn - upright - rate**2 * y - damping * y_rate
        mass = self.share * now.gravity / (GRAVITY * self.radius)
        held = y * level - x * upright + away * across - x * along
        held = held + 2 * (away * y_rate + x * x_rate) * turn
        turned = now.inertia * now.angular_acceleration - mass * held
        turned = turned / (now.inertia - mass * self.radius**2)
        return jnp.stack([turned, across - away * turned, along + x * turned])

    def torque(self, now: Moment, memory: Memory) -> Scalar:
        return now.inertia * (self.accelerations(now, memory)[0] - now.angular_acceleration)

    def memory_at_rest(self, now: Moment) -> Memory:
        sag = GRAVITY / (2 * jnp.pi * self.frequency) ** 2
        still = jnp.zeros(())
        return jnp.stack([-sag * jnp.cos(now.tilted), -sag * jnp.sin(now.tilted), still, still])

    def memory_rate(self, now: Moment, memory: Memory) -> Memory:
        return jnp.concatenate([memory[2:], self.accelerations(now, memory)[1:]])
