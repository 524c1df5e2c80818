"""Two ticks that the firmware looks at as one, in NumPy: of many legs at a time."""

from dataclasses import dataclass

import numpy as np
from float32_movement import integers
from float32_sine import F

GYRO_STEP, FINE_STEP, ZERO_COUNT = F(np.radians(0.07)), F(2 * np.pi / 65536), 32768
HALF_GYRO_STEP, HALF_FINE_STEP = GYRO_STEP / F(2), FINE_STEP / F(2)


def angle_of(count):
    return (count - ZERO_COUNT).astype(F) * FINE_STEP


@dataclass
class Look:
    """Two ticks as one, as sums of their counts."""

    counts: np.ndarray
    gyros: np.ndarray
    sees_angle: np.ndarray
    sees_rate: np.ndarray
    missed: np.ndarray

    @classmethod
    def nothing(cls, legs: int) -> "Look":
        none = integers(legs)
        return cls(none, none, none > 0, none > 0, none)

    def with_next(self, next_: "Look") -> "Look":
        return Look(
            self.counts + next_.counts,
            self.gyros + next_.gyros,
            self.sees_angle & next_.sees_angle,
            self.sees_rate & next_.sees_rate,
            self.missed + next_.missed,
        )

    @property
    def count(self):
        return self.counts >> 1

    @property
    def angle(self):
        return (self.counts - 2 * ZERO_COUNT).astype(F) * HALF_FINE_STEP

    @property
    def rate(self):
        return self.gyros.astype(F) * HALF_GYRO_STEP
