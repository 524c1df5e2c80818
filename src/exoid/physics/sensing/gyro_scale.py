"""A gyro whose rates are too high or too low in proportion."""

from typing import Any

from exoid.physics.moment import Moment
from exoid.physics.parameter import Parameter, parameter
from exoid.physics.term import Memory, Reading, SensorTerm, reading


class GyroScale(SensorTerm):
    """The gyro shows (1 + s) phi'.

    So it does where all times are told a factor 1 + s too long: by such a clock the leg still
    obeys Eq. 9, with other ratios to J.
    """

    title = "scale of the gyro"
    reference = "Arduino_LSM6DS3 issue 64: 61.04 for 70 mdps per count, 12.8 % low"
    explanation = (
        "Counts are converted to deg/s by a wrong factor, or the gyro's axis is not that of the "
        "knee."
    )
    isolate = (
        "the exoskeleton turned by a known right angle, at any speed; a recording of some minutes "
        "beside a watch shows whether it is the clock"
    )
    twin = "clock_rate"
    everyday = True
    replaces = "gyro_scale"

    scale: Parameter = parameter("s", "1", -0.3, 0.3, "scale error", (0.01,))

    @staticmethod
    def as_twin(size: Any) -> Any:
        return -size / (1 + size)

    def shown(self, now: Moment, memory: Memory) -> Reading:
        return reading(angular_velocity=self.scale * now.angular_velocity)
