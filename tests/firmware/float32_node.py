"""The firmware's estimator once more, one NumPy float32 operation after the other."""

from collections.abc import Iterable
from dataclasses import dataclass, fields

import numpy as np

from exoid.recordings.filter.constants import MEASUREMENT_NOISE, PROCESS_NOISE, START_VARIANCE

F = np.float32
Q, R, P = ([F(v) for v in values] for values in (PROCESS_NOISE, MEASUREMENT_NOISE, START_VARIANCE))
STEP = F(0.01)
HALF = F(0.5) * STEP * STEP
ZERO, ONE, NOTHING = F(0), F(1), F(np.nan)

TURN = 4096  # counts
ZERO_COUNT = TURN // 2  # count of 0 rad
ENCODER_STEP = F(2 * np.pi / TURN)  # rad
GYRO_STEP = F(np.radians(0.07))  # rad/s
LONGEST_BLIND = 25  # ticks without a measurement after which the filter stands still


def begin(angle: np.float32, rate: np.float32) -> tuple:
    """x0 x1 x2 x3 p00 p01 p02 p03 p11 p12 p13 p22 p23 p33 after the first sample."""
    x0, p00 = (ZERO, P[0]) if np.isnan(angle) else (angle, R[0])
    x1, p11, p13 = (ZERO, P[1], ZERO) if np.isnan(rate) else (rate, R[1] + P[3], -P[3])
    return x0, x1, ZERO, ZERO, p00, ZERO, ZERO, ZERO, p11, ZERO, p13, P[2], ZERO, P[3]


def predict(belief: tuple) -> tuple:
    x0, x1, x2, x3, p00, p01, p02, p03, p11, p12, p13, p22, p23, p33 = belief
    b00 = p00 + STEP * p01 + HALF * p02
    b01 = p01 + STEP * p11 + HALF * p12
    b02 = p02 + STEP * p12 + HALF * p22
    b03 = p03 + STEP * p13 + HALF * p23
    b11 = p11 + STEP * p12
    b12 = p12 + STEP * p22
    b13 = p13 + STEP * p23
    state = x0 + STEP * x1 + HALF * x2, x1 + STEP * x2, x2, x3
    first = b00 + STEP * b01 + HALF * b02 + Q[0], b01 + STEP * b02, b02, b03
    second = b11 + STEP * b12 + Q[1], b12, b13
    return *state, *first, *second, p22 + Q[2], p23, p33 + Q[3]


def correct(belief: tuple, row: int, measured: np.float32) -> tuple:
    if np.isnan(measured):
        return belief
    x0, x1, x2, x3, p00, p01, p02, p03, p11, p12, p13, p22, p23, p33 = belief
    if row == 0:
        c0, c1, c2, c3 = p00, p01, p02, p03
        e, variance = measured - x0, c0 + R[0]
    else:
        c0, c1, c2, c3 = p01 + p03, p11 + p13, p12 + p23, p13 + p33
        e, variance = measured - (x1 + x3), c1 + c3 + R[1]
    inverse = ONE / variance
    g0, g1, g2, g3 = c0 * inverse, c1 * inverse, c2 * inverse, c3 * inverse
    state = x0 + g0 * e, x1 + g1 * e, x2 + g2 * e, x3 + g3 * e
    first = p00 - g0 * c0, p01 - g0 * c1, p02 - g0 * c2, p03 - g0 * c3
    second = p11 - g1 * c1, p12 - g1 * c2, p13 - g1 * c3
    return *state, *first, *second, p22 - g2 * c2, p23 - g2 * c3, p33 - g3 * c3


def run(angle: Iterable[np.float32], rate: Iterable[np.float32]) -> np.ndarray:
    """The belief after each sample; NaN where nothing was measured."""
    beliefs: list[tuple] = []
    for a, r in zip(angle, rate, strict=True):
        if beliefs:
            beliefs.append(correct(correct(predict(beliefs[-1]), 0, a), 1, r))
        else:
            beliefs.append(begin(a, r))
    return np.array(beliefs, dtype=F)


@dataclass(frozen=True, eq=False)
class Readings:
    """What the frames of consecutive ticks say that was measured, in counts."""

    count: np.ndarray  # RAW.Angle
    gyro: np.ndarray  # RAW.GyroY
    sees_angle: np.ndarray  # neither EncoderFault nor MagnetMissing
    sees_rate: np.ndarray  # neither ImuFault nor GyroSaturated
    reset: np.ndarray  # FilterReset


def rerun(readings: Readings) -> np.ndarray:
    """The node's estimate x0 x1 x2 of each tick, from the first that starts the filter."""
    columns = (getattr(readings, field.name).tolist() for field in fields(Readings))
    states, turned, blind = [], ZERO_COUNT, 0
    for count, gyro, sees_angle, sees_rate, reset in zip(*columns, strict=True):
        turned = ZERO_COUNT if reset else turned
        turned = unwrapped(turned, count) if sees_angle else turned
        angle = F(turned - ZERO_COUNT) * ENCODER_STEP if sees_angle else NOTHING
        rate = F(gyro) * GYRO_STEP if sees_rate else NOTHING
        if reset:
            belief = begin(angle, rate)
        elif sees_angle or sees_rate or blind < LONGEST_BLIND:
            belief = correct(correct(predict(belief), 0, angle), 1, rate)
        blind = 0 if reset or sees_angle or sees_rate else blind + 1
        states.append(belief[:3])
    return np.array(states, dtype=F)


def unwrapped(before: int, count: int) -> int:
    """The count on the turn that is nearest to `before`."""
    return before + (count - before + TURN // 2) % TURN - TURN // 2
