"""An encoder that counts too many or too few degrees."""

from typing import Any, ClassVar

from jaxtyping import Float

from exoid.physics.moment import Moment
from exoid.physics.parameter import parameter
from exoid.physics.term import Memory, Reading, SensorTerm, reading


class EncoderGain(SensorTerm):
    """The encoder shows (1 + g) phi."""

    title: ClassVar[str] = "gain of the encoder"
    reference: ClassVar[str] = "AS5600 datasheet: ZPOS, MPOS and MANG rescale ANGLE"
    explanation: ClassVar[str] = (
        "Counts are converted to degrees by a wrong factor, so that every angle is a few percent "
        "too large or too small."
    )
    isolate: ClassVar[str] = "the exoskeleton turned by a known right angle"

    gain: Float[Any, ""] = parameter("g", "1", -0.2, 0.2, "gain error", (0.01,))

    def shown(self, now: Moment, memory: Memory) -> Reading:
        return reading(self.gain * now.angle)
