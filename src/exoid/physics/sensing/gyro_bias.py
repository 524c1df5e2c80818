"""A gyro that shows a rate at rest."""

from exoid.physics.moment import Moment
from exoid.physics.parameter import Parameter, parameter
from exoid.physics.term import Memory, Reading, SensorTerm, reading


class GyroBias(SensorTerm):
    """The gyro shows phi' + b."""

    title = "bias of the gyro"
    reference = "LSM6DS33 datasheet, Table 3: zero-rate level +-10 deg/s"
    explanation = "The gyro shows a rate while nothing moves."
    isolate = "two seconds at rest before the movement"
    replaces = "gyro_bias"

    bias: Parameter = parameter("b", "rad/s", -0.5, 0.5, "bias", (0.005,))

    def shown(self, now: Moment, memory: Memory) -> Reading:
        return reading(angular_velocity=self.bias)
