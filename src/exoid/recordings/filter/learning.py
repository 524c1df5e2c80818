"""The numbers by which the node learns a leg, beside its Kalman filter.

Until a leg has moved, the node believes what anatomy says (`exoid.expected_leg`) of anybody from a
child of 1.20 m to a man of 2 m, whom it cannot tell apart: m l g / J is 41 to 24 1/s^2 between
them. A knee may have five times the stiffness and damping of a relaxed one. Encoder and seat
together may be 5 deg off. Sensors scatter as their data sheets say.
"""

from dataclasses import dataclass, field
from math import pi, radians, sqrt
from typing import Any

UNKNOWNS = ("gyro_scale", "level_gravity", "upright_gravity", "stiffness", "torque", "damping")
RATIOS = ("gravity", "stiffness", "damping", "torque")  # as they are told

RENEWAL = 1 / 833  # s between the gyro's own samples, which the node reads at any age
ENCODER_STEP, GYRO_STEP = 2 * pi / 4096, radians(0.07)  # rad, rad/s
DEGREE = 65536 // 360  # counts of the encoder's finest step


def with_steps(noise: float, step: float) -> float:
    """The variance of a signal that is read in steps."""
    return noise**2 + step**2 / 12


def number(value: Any, note: str) -> Any:
    """A number, and its unit or meaning."""
    return field(default=value, metadata={"note": note})


@dataclass(frozen=True)
class Learning:
    """What is believed at first, what the sensors do, and when a movement is free and counts."""

    expected: tuple[float, ...] = number(
        (0.0, 30.0, 0.0, 6.6, 0.0, 0.82), "of UNKNOWNS: 1, 1/s^2 four times, 1/s"
    )
    scatter: tuple[float, ...] = number(
        (0.015, 8.0, 2.5, 33.0, 3.0, 4.1), "standard deviations of these"
    )
    bias: float = number(radians(5.0), "rad/s, standard deviation of the gyro's")
    first_rate: float = number(2.0, "rad/s, of the first rate about what the gyro shows")
    angle_variance: float = number(with_steps(radians(0.043), ENCODER_STEP), "rad^2")
    rate_variance: float = number(with_steps(radians(7e-3) * sqrt(833 / 2), GYRO_STEP), "(rad/s)^2")
    late: float = number(RENEWAL / 2, "s, mean age of a gyro's sample")
    wander_variance: float = number(RENEWAL**2 / 12, "s^2, of that age")
    roughness: float = number(2e-10, "(rad/s)^2 a tick: rounding, and what no model has")
    fading: float = number(1.05, "by which variances grow from one movement to the next")
    gate: float = number(25.0, "chi-square up to which a measurement is believed")
    caution: float = number(
        1.25, "by which variances are told larger: the filter is not quite linear"
    )
    least_error: tuple[float, ...] = number(
        (0.01, 0.01, 0.0005, 0.01), "of RATIOS: no error is told smaller"
    )
    good: float = number(0.01, "share of gravity that errors may be")
    enough: float = number(0.003, "the same, of one that another drop hardly changes")
    least_gravity: float = number(10.0, "1/s^2, below which it is no leg")
    pull: float = number(2.0, "rad/s^2 by which a leg that is let go falls at least")
    matters: float = number(0.03, "share of gravity by which another leg differs")
    apart: float = number(16.0, "squared standard deviations by which it does")

    memory: float = number(0.9, "of the innovations before, for their whiteness")
    fade: float = number(1 - 1 / 150, "a tick, of what is known of innovations")
    fewest: float = number(30.0, "innovations before they say anything")
    unwhite: float = number(64.0, "squared standard deviations that no white noise reaches")
    sound: float = number(9.0, "the same, up to which a movement is explained")
    power: float = number(4.0, "mean square of innovations that is no noise")

    rest: int = number(30, "ticks that a leg at rest is still")
    still: int = number(DEGREE, "counts that it may move in that time")
    departed: int = number(2 * DEGREE, "counts from its hold, or back from a turn")
    letting_go: int = number(8, "ticks that a hand takes to be off the leg")
    caught: int = number(3, "samples in a row that are no leg's")
    shortest: int = number(40, "ticks of a movement that counts")
    kept: int = number(15, "ticks between two keepings: a hand is seen that late at most")
    longest_blind: int = number(2, "ticks without an angle that are bridged")
    longest_silent: int = number(10, "the same of the gyro, in a movement")
    swung: int = number(2, "turns after its end by which a movement was no hand's")
    failures: int = number(2, "movements in a row that fail, until the leg is learned anew")
    faults: int = number(100, "of a stream that is faulty; each lost sample is fault_weight")
    fault_weight: int = number(25, "and one is forgotten a tick")
    frozen: int = number(50, "samples of the same rate: noise alone moves it")


LEARNING = Learning()
