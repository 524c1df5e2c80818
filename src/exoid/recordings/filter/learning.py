"""The numbers by which the node learns a leg, beside its Kalman filter.

Until a leg has moved, the node believes what anatomy says (`exoid.expected_leg`) of anybody from a
child of 1.20 m to a man of 2 m, whom it cannot tell apart: m l g / J is 41 to 24 1/s^2 between
them. A knee may have five times the stiffness and damping of a relaxed one. Encoder and seat
together may be 5 deg off. The frame may rub, by some tenths of a newton metre at 0.3 kg m^2.
Sensors scatter as their data sheets say; a gyro's sample may be 2 ms old, and the encoder's magnet
off its axis, so that its angle is wrong by some tenths of a degree once a turn.

Two ticks are looked at as one: a leg is slow beside them, and their mean tells as much of it at
half of the work.
"""

from dataclasses import dataclass, field
from math import pi, radians, sqrt
from typing import Any

SENSED = ("gyro_scale", "gyro_age", "level_error", "upright_error")  # of the sensors
UNKNOWNS = (
    *SENSED,
    *("level_gravity", "upright_gravity", "stiffness", "torque", "damping", "friction"),
)
RATIOS = ("gravity", "stiffness", "damping", "torque", "friction")  # as they are told
TICKS = 2  # that are looked at as one

RENEWAL = 1 / 833  # s between the gyro's own samples, which the node reads at any age
ENCODER_STEP, GYRO_STEP = 2 * pi / 4096, radians(0.07)  # rad, rad/s
DEGREE = 65536 // 360  # counts of the encoder's finest step


def with_steps(noise: float, step: float) -> float:
    """The variance of the mean of ticks, of a signal that is read in steps."""
    return (noise**2 + step**2 / 12) / TICKS


def number(value: Any, note: str) -> Any:
    """A number, and its unit or meaning."""
    return field(default=value, metadata={"note": note})


@dataclass(frozen=True)
class Learning:
    """What is believed at first, what the sensors do, and when a movement is free and counts."""

    expected: tuple[float, ...] = number(
        (0.0, 8e-4, 0.0, 0.0, 30.0, 0.0, 6.6, 0.0, 0.82, 0.0),
        "of UNKNOWNS: 1, s, rad twice, 1/s^2 four times, 1/s, 1/s^2",
    )
    scatter: tuple[float, ...] = number(
        (0.015, 7e-4, 4e-3, 4e-3, 8.0, 2.5, 33.0, 3.0, 4.1, 0.5), "standard deviations of these"
    )
    bias: float = number(radians(5.0), "rad/s, standard deviation of the gyro's")
    angle_variance: float = number(with_steps(radians(0.043), ENCODER_STEP), "rad^2, of a mean")
    rate_variance: float = number(
        with_steps(radians(7e-3) * sqrt(833 / 2), GYRO_STEP), "(rad/s)^2, of a mean"
    )
    wander_variance: float = number(
        RENEWAL**2 / 12 / TICKS, "s^2, of the age of the gyro's sample about its mean"
    )
    least_turn: float = number(0.02, "rad/s within which dry friction is led through 0")
    roughness: float = number(4e-10, "(rad/s)^2 a look: rounding, and what no model has")
    fading: float = number(1.05, "by which variances grow from one movement to the next")
    first_fading: float = number(
        2.0, "the same, from the first: the filter is not linear in what was believed before"
    )
    doubt: float = number(
        0.05,
        "of the variance of what is expected of a measurement that is added to its own: as fading",
    )
    gate: float = number(25.0, "chi-square up to which a measurement is believed")
    caution: float = number(
        1.25, "by which variances are told larger: the filter is not quite linear"
    )
    least_error: tuple[float, ...] = number(
        (0.01, 0.01, 0.0005, 0.01, 0.002), "of RATIOS: no error is told smaller"
    )
    good: float = number(0.01, "share of gravity that errors may be")
    enough: float = number(0.003, "the same, of one that another drop hardly changes")
    least_gravity: float = number(10.0, "1/s^2, below which it is no leg")
    pull: float = number(2.0, "rad/s^2 by which a leg that is let go falls at least")
    matters: float = number(0.03, "share of gravity by which another leg differs")
    apart: float = number(9.0, "squared standard deviations by which it does")

    memory: float = number(0.81, "of the innovations before, for their whiteness")
    fade: float = number(1 - 1 / 75, "a look, of what is known of innovations")
    fewest: float = number(15.0, "innovations before they say anything")
    unwhite: float = number(64.0, "squared standard deviations that no white noise reaches")
    sound: float = number(9.0, "the same, up to which a movement is explained")
    power: float = number(4.0, "mean square of innovations that is no noise")

    rest: int = number(30, "ticks that a leg at rest is still")
    still: int = number(DEGREE, "counts that it may move in that time")
    departed: int = number(2 * DEGREE, "counts from its hold, or back from a turn")
    letting_go: int = number(4, "looks that a hand takes to be off the leg")
    caught: int = number(3, "looks in a row that are no leg's")
    shortest: int = number(28, "looks of a movement that counts")
    kept: int = number(7, "looks between two keepings: a hand is seen that late at most")
    longest_blind: int = number(2, "ticks without an angle that are bridged")
    longest_silent: int = number(10, "the same of the gyro, in a movement")
    swung: int = number(2, "turns after its end by which a movement was no hand's")
    failures: int = number(2, "movements in a row that fail, until the leg is learned anew")
    faults: int = number(100, "of a stream that is faulty; each lost sample is fault_weight")
    fault_weight: int = number(25, "and one is forgotten a tick")
    frozen: int = number(50, "samples of the same rate: noise alone moves it")


LEARNING = Learning()
