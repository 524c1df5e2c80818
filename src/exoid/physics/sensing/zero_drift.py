"""An encoder that moves on the leg while it records."""

from exoid.physics.moment import Moment
from exoid.physics.parameter import Parameter, parameter
from exoid.physics.term import Memory, Reading, SensorTerm, reading


class ZeroDrift(SensorTerm):
    """The encoder shows phi + u t + w n, t seconds into segment n, which counts from 0.

    To a gyro the first part is a bias.
    """

    title = "drift of the encoder's zero"
    reference = "straps that slip down a leg: no number is published"
    explanation = (
        "The encoder's zero wanders off by and by: straps creep along the leg, or a phone sums up "
        "what its gyro is off by."
    )
    isolate = "the leg straight, or hanging still, before and after the movement"
    isolate_rig = isolate_driven = "the axis at the same mark, before and after the movement"

    moves_zero = True

    drift: Parameter = parameter("u", "rad/s", -0.05, 0.05, "drift", (0.002,))
    step: Parameter = parameter("w", "rad", -0.1, 0.1, "step from segment to segment", (0.0,))

    def shown(self, now: Moment, memory: Memory) -> Reading:
        return reading(self.drift * now.time + self.step * now.place.number)
