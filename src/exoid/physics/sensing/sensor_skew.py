"""A gyro that is read earlier or later than the encoder."""

from typing import Any, ClassVar

from jaxtyping import Float

from exoid.physics.moment import Moment
from exoid.physics.parameter import parameter
from exoid.physics.term import Memory, Reading, SensorTerm, reading


class SensorSkew(SensorTerm):
    """The gyro shows phi'(t - t_s)."""

    title: ClassVar[str] = "time between encoder and gyro"
    reference: ClassVar[str] = "LSM6DS3 datasheet: low-pass filter; I2C order of reading"
    explanation: ClassVar[str] = (
        "Gyro and encoder are not of the same instant: one is read later, or filtered."
    )
    isolate: ClassVar[str] = "quick movements by hand; the delay shows without any leg model"
    everyday: ClassVar[bool] = True

    skew: Float[Any, ""] = parameter("t_s", "s", -0.06, 0.06, "delay of the gyro", (0.001,))

    def shown(self, now: Moment, memory: Memory) -> Reading:
        return reading(delay=self.skew)
