"""One sample of a leg as an estimator takes it in."""

from typing import NamedTuple


class Reading(NamedTuple):
    """What was measured at an instant; NaN is missing."""

    time: float  # s, on the stream's clock
    angle: float  # rad
    angular_velocity: float  # rad/s
    torque: float = 0.0  # N m, known, extension positive
    begins: bool = False  # is it the first of a movement's record?
