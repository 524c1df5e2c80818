"""Soft tissue that swings on the bone."""

from typing import Any, ClassVar

import jax.numpy as jnp
from jaxtyping import Array, Float

from exoid.physics.moment import Moment
from exoid.physics.parameter import parameter
from exoid.physics.term import Memory, PhysicsTerm


class WobblingMass(PhysicsTerm):
    """A share beta of the leg's inertia and weight hangs on the bone by a spring and a damper.

    chi'' = (2 pi f)^2 (phi - chi) + 2 zeta 2 pi f (phi' - chi') - m l g cos(chi) / J.
    Its memory is (chi - phi, chi').
    """

    title: ClassVar[str] = "soft tissue that wobbles on the bone"
    reference: ClassVar[str] = "Nikooyan & Zadpoor, Proc IMechE H 225(12), 2011"
    explanation: ClassVar[str] = (
        "Calf muscle and skin follow the bone with a delay and ring after it, which a rigid leg "
        "cannot."
    )
    isolate: ClassVar[str] = "a movement that is stopped abruptly, with a gyro above 100 Hz"
    memory_size: ClassVar[int] = 2
    substeps: ClassVar[int] = 2

    share: Float[Any, ""] = parameter("beta", "1", 0.0, 0.6, "share of the leg", (0.15,))
    frequency: Float[Any, ""] = parameter("f", "Hz", 1.2, 20.0, "wobbling frequency", (3.0, 8.0))
    damping_ratio: Float[Any, ""] = parameter("zeta", "1", 0.02, 2.0, "its damping ratio", (0.2,))

    def held(self, now: Moment, memory: Memory) -> Float[Array, ""]:
        """By how much the bone accelerates the soft tissue [rad/s^2]."""
        rate = 2 * jnp.pi * self.frequency
        slip = now.angular_velocity - memory[1]
        return -(rate**2) * memory[0] + 2 * self.damping_ratio * rate * slip

    def torque(self, now: Moment, memory: Memory) -> Float[Array, ""]:
        weight = now.gravity * jnp.cos(now.tilted)
        freed = now.inertia * (now.angular_acceleration - self.held(now, memory)) + weight
        return self.share / (1 - self.share) * freed

    def memory_at_rest(self, now: Moment) -> Memory:
        sag = now.gravity * jnp.cos(now.tilted) / now.inertia
        return jnp.stack([-sag / (2 * jnp.pi * self.frequency) ** 2, now.angular_velocity])

    def memory_rate(self, now: Moment, memory: Memory) -> Memory:
        weight = now.gravity * jnp.cos(now.tilted + memory[0]) / now.inertia
        return jnp.stack([memory[1] - now.angular_velocity, self.held(now, memory) - weight])
