"""An encoder whose zero is not where the knee is straight, or gravity that is tilted."""

from exoid.physics.moment import Moment
from exoid.physics.parameter import Parameter, parameter
from exoid.physics.term import Memory, Reading, SensorTerm, reading


class AngleOffset(SensorTerm):
    """The encoder shows phi + delta."""

    title = "offset of the angle (encoder zero, or tilted thigh)"
    reference = "AS5600 datasheet: the zero is where it was programmed"
    explanation = (
        "Zero on the encoder is not the horizontal shank: the magnet was mounted turned, the "
        "exoskeleton put on askew, or the thigh was not level."
    )
    isolate = "the accelerometer at rest, or the hanging leg against a plumb line"
    isolate_rig = isolate_driven = "the rig at rest, by a plumb line or a spirit level"
    replaces = "zero"
    opposite = "stiffness_rest_angle"  # together a tilted thigh

    offset: Parameter = parameter("delta", "rad", -0.4, 0.4, "offset", (0.03, -0.03))

    def shown(self, now: Moment, memory: Memory) -> Reading:
        return reading(self.offset)
