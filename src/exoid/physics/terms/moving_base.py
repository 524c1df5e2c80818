"""The thigh gives way under the swinging leg."""

from typing import Any, ClassVar

import jax.numpy as jnp
from jaxtyping import Array, Float

from exoid.physics.moment import Moment
from exoid.physics.parameter import parameter
from exoid.physics.term import Memory, PhysicsTerm, Reading, reading


class MovingBase(PhysicsTerm):
    """The thigh pitches by theta about the hip, pushed by what the leg does to the knee.

    theta'' = (2 pi f)^2 (C M - theta) - 2 zeta 2 pi f theta',
    M = c phi + d phi' - tau_h - L m l (phi'' cos(phi) - phi'^2 sin(phi)).
    phi is the leg's angle in space: spring and damper feel phi - theta, the knee moves by L theta,
    the encoder shows phi - theta - theta_0, a gyro on the leg phi'. Its memory is (theta, theta').
    """

    title: ClassVar[str] = "the thigh moves under the leg"
    reference: ClassVar[str] = "Valle et al., Clinical Biomechanics 21(8), 2006: thigh motion"
    explanation: ClassVar[str] = (
        "Seat, hip and thigh give way as the leg swings, so that the knee is no fixed pivot; the "
        "gyro sees it, the encoder does not."
    )
    isolate: ClassVar[str] = "the same drops with the thigh strapped down, or an IMU on the thigh"
    memory_size: ClassVar[int] = 2
    substeps: ClassVar[int] = 2

    compliance: Float[Any, ""] = parameter(
        "C", "rad/(N m)", 0.0, 0.05, "compliance of hip and seat", (0.0008,)
    )
    thigh_length: Float[Any, ""] = parameter("L", "m", 0.2, 0.6, "hip to knee", (0.42,))
    frequency: Float[Any, ""] = parameter("f", "Hz", 1.0, 20.0, "of the thigh", (4.0, 10.0))
    damping_ratio: Float[Any, ""] = parameter("zeta", "1", 0.02, 2.0, "of the thigh", (0.4,))
    sag: Float[Any, ""] = parameter("theta_0", "rad", -0.2, 0.2, "how far it gave way", (0.0,))

    def knee_moment(self, now: Moment) -> Float[Array, ""]:
        """M [N m] at the hip."""
        heave = now.angular_acceleration * jnp.cos(now.tilted)
        heave = heave - now.angular_velocity**2 * jnp.sin(now.tilted)
        passive = now.stiffness * now.angle + now.damping * now.angular_velocity
        drive = now.place.cycle.torque(now.time)
        return passive - drive - self.thigh_length * now.gravity / 9.81 * heave

    def pitching(self, now: Moment, memory: Memory) -> Float[Array, ""]:
        """theta''."""
        rate = 2 * jnp.pi * self.frequency
        settled = self.compliance * self.knee_moment(now)
        return rate**2 * (settled - memory[0]) - 2 * self.damping_ratio * rate * memory[1]

    def torque(self, now: Moment, memory: Memory) -> Float[Array, ""]:
        passive = now.stiffness * (memory[0] + self.sag) + now.damping * memory[1]
        lift = self.thigh_length * self.pitching(now, memory)
        return passive - now.gravity / 9.81 * lift * jnp.cos(now.tilted)

    def memory_at_rest(self, now: Moment) -> Memory:
        return jnp.stack([self.compliance * self.knee_moment(now), jnp.zeros(())])

    def memory_rate(self, now: Moment, memory: Memory) -> Memory:
        return jnp.stack([memory[1], self.pitching(now, memory)])

    def shown(self, now: Moment, memory: Memory) -> Reading:
        return reading(-memory[0] - self.sag)
