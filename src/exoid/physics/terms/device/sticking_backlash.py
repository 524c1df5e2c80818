"""Play between the leg and a frame that stays where it is as long as nothing pushes it."""

import jax.numpy as jnp

from exoid.physics.moment import Moment
from exoid.physics.parameter import Parameter, parameter
from exoid.physics.term import Memory, PhysicsTerm, Reading, reading
from exoid.physics.terms.device.backlash import Backlash

TOUCH = 1e-6  # relative, within which leg and frame are in contact


class StickingBacklash(PhysicsTerm):
    """The frame q follows the leg only once the play 2 b is used up: |phi - q| <= b.

    It is `Backlash` of a frame without weight. Its memory is q - phi, within the play.
    """

    title = "play between leg and a frame that sticks"
    reference = "Visintin, Differential Models of Hysteresis, 1994: play operator"
    explanation = (
        "Slack straps or a worn hinge whose friction holds what carries the sensors: after every "
        "turn the leg moves for a moment before they do."
    )
    isolate = Backlash.isolate
    isolate_rig = Backlash.isolate_rig
    isolate_driven = Backlash.isolate_driven
    memory_size = 1
    jumps = True
    substeps = 4  # it stops at the end of one, and not where the leg turns

    half_play: Parameter = parameter("b", "rad", 0.0, 0.1, "half the play", (0.004, 0.015))

    def memory_rate(self, now: Moment, memory: Memory) -> Memory:
        return -now.angular_velocity[None]

    def memory_within(self, now: Moment, memory: Memory) -> Memory:
        return jnp.clip(memory, -self.half_play, self.half_play)

    def shown(self, now: Moment, memory: Memory) -> Reading:
        inside = jnp.abs(memory[0]) < self.half_play * (1 - TOUCH)
        return reading(memory[0], jnp.where(inside, -now.angular_velocity, 0.0))
