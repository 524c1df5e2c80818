"""An encoder that counts too many or too few degrees."""

from exoid.physics.moment import Moment
from exoid.physics.parameter import Parameter, parameter
from exoid.physics.term import Memory, Reading, SensorTerm, reading


class EncoderGain(SensorTerm):
    """The encoder shows (1 + g) phi."""

    title = "gain of the encoder"
    reference = "AS5600 datasheet: ZPOS, MPOS and MANG rescale ANGLE"
    explanation = (
        "Counts are converted to degrees by a wrong factor, so that every angle is a few percent "
        "too large or too small."
    )
    isolate = "the exoskeleton turned by a known right angle"
    isolate_rig = isolate_driven = "the axis turned by a known right angle"

    gain: Parameter = parameter("g", "1", -0.2, 0.2, "gain error", (0.01,))

    def shown(self, now: Moment, memory: Memory) -> Reading:
        return reading(self.gain * now.angle)
