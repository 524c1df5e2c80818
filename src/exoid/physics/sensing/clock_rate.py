"""A clock that runs too fast or too slow."""

from typing import Any

from exoid.physics.moment import Moment
from exoid.physics.parameter import Parameter, parameter
from exoid.physics.term import Memory, Reading, Scalar, SensorTerm, reading


class ClockRate(SensorTerm):
    """A recorded second is (1 + k) s long: the gyro shows phi' / (1 + k) of the recorded rate phi'.

    By the recorded time t the leg of Eq. 9 obeys
    J phi'' = (1 + k)^2 (tau - m l g cos(phi) - c phi) - (1 + k) d phi'; what that has beyond Eq. 9
    is the `torque`, so that m, J, l, d and c stay those of the true clock.
    """

    title = "rate of the clock"
    reference = "LSM6DS3 datasheet: output data rates within some percent; a quartz: 1e-4"
    explanation = (
        "Samples are farther apart, or closer, than their times say: a nominal rate was taken for "
        "the true one, or a cheap oscillator drives the recorder."
    )
    isolate = (
        "a recording of some minutes beside a watch; the exoskeleton turned by a known right angle "
        "shows whether it is the gyro's scale"
    )
    twin = "gyro_scale"
    named_only = True
    inertial = True
    replaces = "clock"

    rate: Parameter = parameter("k", "1", -0.05, 0.05, "rate error", (0.005,))

    @staticmethod
    def as_twin(size: Any) -> Any:
        return -size / (1 + size)

    def torque(self, now: Moment, memory: Memory) -> Scalar:
        squared, ratios = self.rate * (2 + self.rate), now.place.ratios
        undamped = now.angular_acceleration + ratios.damping * now.angular_velocity
        slower = squared * undamped - self.rate * ratios.damping * now.angular_velocity
        return now.inertia * slower

    def shown(self, now: Moment, memory: Memory) -> Reading:
        return reading(angular_velocity=-self.rate / (1 + self.rate) * now.angular_velocity)
