"""Play between the leg and the frame that carries the sensors."""

from typing import Any, ClassVar

import jax.numpy as jnp
from jaxtyping import Float

from exoid.physics.moment import Moment
from exoid.physics.parameter import parameter
from exoid.physics.term import Memory, PhysicsTerm, Reading, reading

TOUCH = 1e-6  # relative, within which leg and frame are in contact


class Backlash(PhysicsTerm):
    """The frame q follows the leg only once the play 2 b is used up: |phi - q| <= b.

    Its memory is q - phi, within the play.
    """

    title: ClassVar[str] = "play between leg and frame"
    reference: ClassVar[str] = "Visintin, Differential Models of Hysteresis, 1994: play operator"
    explanation: ClassVar[str] = (
        "Slack straps or a worn hinge: after every turn the leg moves for a moment before the "
        "sensors do."
    )
    isolate: ClassVar[str] = "the leg held, the frame moved by hand through its play"
    memory_size: ClassVar[int] = 1
    jumps: ClassVar[bool] = True

    half_play: Float[Any, ""] = parameter("b", "rad", 0.0, 0.1, "half the play", (0.004, 0.015))

    def memory_rate(self, now: Moment, memory: Memory) -> Memory:
        return -now.angular_velocity[None]

    def memory_within(self, now: Moment, memory: Memory) -> Memory:
        return jnp.clip(memory, -self.half_play, self.half_play)

    def shown(self, now: Moment, memory: Memory) -> Reading:
        inside = jnp.abs(memory[0]) < self.half_play * (1 - TOUCH)
        return reading(memory[0], jnp.where(inside, -now.angular_velocity, 0.0))
