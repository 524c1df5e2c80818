"""Play between the leg and the frame that carries the sensors, which has a weight of its own."""

import jax.numpy as jnp

from exoid.physics.moment import Moment
from exoid.physics.parameter import Parameter, parameter
from exoid.physics.term import Memory, PhysicsTerm, Reading, Scalar, reading
from exoid.physics.terms.device.hard_stop import spring_and_damper

FELT = 0.01  # N m, from which on the friction of the hinge is dry friction of what moves
TIGHT = 1e-4  # rad, half a play that no encoder sees
CLINGS = 800.0  # rad/s, of a frame that dry friction holds: within 30 urad for 20 rad/s^2


class Backlash(PhysicsTerm):
    """Encoder and gyro sit on a frame (q) that is free within the play 2 b; s = q - phi.

    Beyond it, at the depth x = |s| - b, they push each other, but never pull:

        tau = -p,  J_e q'' = p - G_e cos(q) - d_h q' - F_h sgn(q'),
        p = -sgn(s) J_e max(0, w^2 x + 2 zeta w x'),  w = pi / t_c.

    Friction that holds the frame is a stiff, damped spring z that yields at F_h. The
    memory is (s, q', z).
    """

    title = "play between leg and frame"
    reference = "Nordin & Gutman, Automatica 38(10), 2002: two masses with play"
    explanation = (
        "Slack straps or a worn hinge: around every turn leg and frame part, and what carries the "
        "sensors moves by its own weight until they meet again."
    )
    isolate = "the leg held, the frame moved by hand through its play"
    isolate_rig = "the frame held, the rig moved by hand through its play"
    isolate_driven = "the motor held, the axis moved by hand through its play"
    memory_size = 3
    jumps = True
    substeps = 8

    half_play: Parameter = parameter(
        "b", "rad", 0.0, 0.1, "half the play", (0.008, 0.022), law=0.015
    )
    frame_inertia: Parameter = parameter(
        "J_e", "kg m^2", 0.003, 0.1, "inertia of the frame", (0.012,)
    )
    frame_gravity: Parameter = parameter(
        "G_e", "N m", 0.0, 6.0, "gravity moment of the frame", (0.5,)
    )
    hinge_friction: Parameter = parameter(
        "F_h", "N m", 0.0, 2.0, "dry friction of the frame's hinge", (0.03, 0.15)
    )
    hinge_damping: Parameter = parameter(
        "d_h", "N m s/rad", 0.0, 1.0, "damping of the frame's hinge", (0.02,)
    )
    contact_time: Parameter = parameter(
        "t_c", "s", 0.006, 0.02, "how long a bounce lasts", (0.012,)
    )
    damping_ratio: Parameter = parameter(
        "zeta", "1", 0.0, 1.5, "damping ratio of the contact", (0.7,)
    )

    def includes(self) -> str:
        return "coulomb_friction" if self.hinge_friction > FELT else ""

    def itself(self) -> bool:
        """Can it move? A frame without play only rubs."""
        return bool(self.half_play > TIGHT)

    @property
    def rate(self) -> Scalar:
        return jnp.pi / self.contact_time

    def pushed(self, now: Moment, memory: Memory) -> Scalar:
        """The torque of the leg on the frame over the frame's inertia [rad/s^2]."""
        how = now.place.slack, self.rate, self.damping_ratio
        extension, flexion = (spring_and_damper(*gap, *how) for gap in self.gaps(now, memory))
        return flexion - extension

    def gaps(self, now: Moment, memory: Memory) -> tuple[tuple[Scalar, Scalar], ...]:
        slip, speed, _ = memory
        grows = speed - now.angular_velocity
        return (self.half_play - slip, -grows), (self.half_play + slip, grows)

    def torque(self, now: Moment, memory: Memory) -> Scalar:
        return -self.frame_inertia * self.pushed(now, memory)

    def memory_at_rest(self, now: Moment) -> Memory:
        weight = self.frame_gravity * jnp.cos(now.tilted)
        sunk = weight / (self.frame_inertia * self.rate**2)
        slip = -jnp.sign(weight) * self.half_play - sunk
        return jnp.stack([slip, now.angular_velocity, jnp.zeros_like(slip)])

    def memory_rate(self, now: Moment, memory: Memory) -> Memory:
        slip, speed, held = memory
        level = self.hinge_friction / self.frame_inertia
        friction = jnp.clip(CLINGS**2 * held + CLINGS * speed, -level, level)
        pull = self.frame_gravity * jnp.cos(now.tilted + slip) + self.hinge_damping * speed
        moved = self.pushed(now, memory) - pull / self.frame_inertia - friction
        return jnp.stack([speed - now.angular_velocity, moved, speed])

    def memory_within(self, now: Moment, memory: Memory) -> Memory:
        most = self.hinge_friction / (self.frame_inertia * CLINGS**2)
        return jnp.stack([*memory[:2], jnp.clip(memory[2], -most, most)])

    def shown(self, now: Moment, memory: Memory) -> Reading:
        return reading(memory[0], memory[1] - now.angular_velocity)
