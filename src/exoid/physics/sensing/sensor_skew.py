"""A gyro that is read earlier or later than the encoder."""

from exoid.physics.moment import Moment
from exoid.physics.parameter import Parameter, parameter
from exoid.physics.term import Memory, Reading, SensorTerm, reading


class SensorSkew(SensorTerm):
    """The gyro shows phi'(t - t_s)."""

    title = "time between encoder and gyro"
    reference = "LSM6DS3 datasheet: low-pass filter; I2C order of reading"
    explanation = "Gyro and encoder are not of the same instant: one is read later, or filtered."
    isolate = "quick movements by hand; the delay shows without any leg model"
    everyday = True

    skew: Parameter = parameter("t_s", "s", -0.06, 0.06, "delay of the gyro", (0.001,))

    def shown(self, now: Moment, memory: Memory) -> Reading:
        return reading(delay=self.skew)
