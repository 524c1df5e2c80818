"""The numbers of the firmware's Kalman filter, and of the one before it.

The gyro's bias is a random walk that starts anywhere within the zero-rate level of the data sheet,
10 deg/s. It walks with the chip's temperature, by 0.05 deg/s per degree: a board that warms by
three degrees a minute, as one that was just switched on, goes 2.6e-3 rad/s in 6000 steps, whose
square is 1.1e-9 a step.
"""

from dataclasses import dataclass

PROCESS_NOISE = (1e-8, 1e-5, 0.6, 1e-9)  # Q per step of 10 ms: rad, rad/s, rad/s^2, rad/s squared
MEASUREMENT_NOISE = (8e-7, 1.2e-5)  # R: encoder rad^2, gyro (rad/s)^2
START_VARIANCE = (10.0, 100.0, 100.0, 0.03)  # P before anything was measured, units of Q


@dataclass(frozen=True)
class Design:
    """The variances of a filter of angle, velocity, acceleration and the gyro's bias."""

    process_noise: tuple[float, float, float, float]
    measurement_noise: tuple[float, float]
    start_variance: tuple[float, float, float, float]


OF_NODE = Design(PROCESS_NOISE, MEASUREMENT_NOISE, START_VARIANCE)
# A bias that is known to be 0 stays so: to the bit, that is the filter of three states.
UNBIASED = Design((*PROCESS_NOISE[:3], 0.0), MEASUREMENT_NOISE, (*START_VARIANCE[:3], 0.0))
DESIGNS = {"3 states": UNBIASED, "4 states": OF_NODE}  # by what [sensors] calls them
CURRENT, UNTOLD = "4 states", "3 states"  # of the firmware; of a file that does not say
