"""The exoskeleton's frame moves against the shank."""

import jax.numpy as jnp

from exoid.physics.moment import Moment
from exoid.physics.parameter import Parameter, parameter
from exoid.physics.term import Memory, PhysicsTerm, Reading, Scalar, reading


class CuffCompliance(PhysicsTerm):
    """Encoder and gyro sit on a frame (q) that a spring k = 1/C and a damper tie to the leg.

    tau = -k (phi - q) - b (phi' - q'),
    J_e q'' = k (phi - q) + b (phi' - q') - G_e cos(q) - d_h q',  b = 2 zeta sqrt(k J_e).
    Its memory is (q - phi, q').
    """

    title = "compliant cuffs: the frame moves against the shank"
    reference = "Barrutia et al., 2023; Massardi et al., 2022: cuff interfaces"
    explanation = (
        "The sensors ride on the exoskeleton's frame, which gives way against the shank through "
        "cuffs and soft tissue."
    )
    isolate = "a second IMU taped to the shin, or a tap on the frame at rest"
    memory_size = 2
    substeps = 4
    living = True

    compliance: Parameter = parameter(
        "C", "rad/(N m)", 2e-3, 0.3, "compliance of the cuffs", (0.02, 0.08)
    )
    frame_inertia: Parameter = parameter(
        "J_e", "kg m^2", 0.005, 0.2, "inertia of the frame", (0.02,)
    )
    frame_gravity: Parameter = parameter(
        "G_e", "N m", 0.0, 6.0, "gravity moment of the frame", (0.8,)
    )
    hinge_damping: Parameter = parameter(
        "d_h", "N m s/rad", 0.0, 1.0, "damping of the frame's hinge", (0.1,)
    )
    damping_ratio: Parameter = parameter(
        "zeta", "1", 0.02, 1.0, "damping ratio of the cuffs", (0.3,)
    )

    def carried(self, now: Moment, memory: Memory) -> Scalar:
        """The torque of the leg on the frame."""
        stiffness = 1 / self.compliance
        damper = 2 * self.damping_ratio * jnp.sqrt(stiffness * self.frame_inertia)
        return -stiffness * memory[0] + damper * (now.angular_velocity - memory[1])

    def torque(self, now: Moment, memory: Memory) -> Scalar:
        return -self.carried(now, memory)

    def memory_at_rest(self, now: Moment) -> Memory:
        gravity = self.frame_gravity * jnp.cos(now.tilted)
        return jnp.stack([-gravity * self.compliance, now.angular_velocity])

    def memory_rate(self, now: Moment, memory: Memory) -> Memory:
        pull = self.frame_gravity * jnp.cos(now.tilted + memory[0]) + self.hinge_damping * memory[1]
        moved = (self.carried(now, memory) - pull) / self.frame_inertia
        return jnp.stack([memory[1] - now.angular_velocity, moved])

    def shown(self, now: Moment, memory: Memory) -> Reading:
        return reading(memory[0], memory[1] - now.angular_velocity)
