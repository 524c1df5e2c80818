"""A gyro that shows a rate at rest."""

from typing import Any, ClassVar

from jaxtyping import Float

from exoid.physics.moment import Moment
from exoid.physics.parameter import parameter
from exoid.physics.term import Memory, Reading, SensorTerm, reading


class GyroBias(SensorTerm):
    """The gyro shows phi' + b."""

    title: ClassVar[str] = "bias of the gyro"
    reference: ClassVar[str] = "LSM6DS33 datasheet, Table 3: zero-rate level +-10 deg/s"
    explanation: ClassVar[str] = "The gyro shows a rate while nothing moves."
    isolate: ClassVar[str] = "two seconds at rest before the movement"
    replaces: ClassVar[str] = "gyro_bias"

    bias: Float[Any, ""] = parameter("b", "rad/s", -0.5, 0.5, "bias", (0.005,))

    def shown(self, now: Moment, memory: Memory) -> Reading:
        return reading(angular_velocity=self.bias)
