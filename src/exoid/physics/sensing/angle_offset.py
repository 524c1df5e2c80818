"""An encoder whose zero is not where the knee is straight, or gravity that is tilted."""

from typing import Any, ClassVar

from jaxtyping import Float

from exoid.physics.moment import Moment
from exoid.physics.parameter import parameter
from exoid.physics.term import Memory, Reading, SensorTerm, reading


class AngleOffset(SensorTerm):
    """The encoder shows phi + delta."""

    title: ClassVar[str] = "offset of the angle (encoder zero, or tilted thigh)"
    reference: ClassVar[str] = "AS5600 datasheet: the zero is where it was programmed"
    explanation: ClassVar[str] = (
        "Zero on the encoder is not the horizontal shank: the magnet was mounted turned, the "
        "exoskeleton put on askew, or the thigh was not level."
    )
    isolate: ClassVar[str] = "the accelerometer at rest, or the hanging leg against a plumb line"
    replaces: ClassVar[str] = "zero"
    opposite: ClassVar[str] = "stiffness_rest_angle"  # together a tilted thigh

    offset: Float[Any, ""] = parameter("delta", "rad", -0.4, 0.4, "offset", (0.03, -0.03))

    def shown(self, now: Moment, memory: Memory) -> Reading:
        return reading(self.offset)
