"""What the node's chips show of the frame: an encoder of 12 bits, a gyro with samples of an age."""

from dataclasses import dataclass

import numpy as np
from benchmarks.closed_loop.node import Readings
from benchmarks.closed_loop.plant import State
from benchmarks.closed_loop.rig import GRAVITY

DEGREE = np.pi / 180
TURN, ZERO = 4096, 2048  # counts, AS5600; that of the extended knee
ENCODER_NOISE = 0.043 * DEGREE  # rad, AS5600
GYRO_STEP = 0.07 * DEGREE  # rad/s a count, LSM6DS3 at 2000 deg/s
GYRO_NOISE = 7e-3 * DEGREE * np.sqrt(833 / 2)  # rad/s, LSM6DS3 at 833 Hz
ACCELERATION_STEP = 0.122e-3 * GRAVITY  # m/s^2 a count, LSM6DS3 at 4 g
RENEWAL = 1 / 833  # s between the gyro's own samples


@dataclass(frozen=True)
class Faults:
    """What is wrong with the sensors of one rig."""

    zero: float  # rad, by which the encoder's zero is off
    bias: float  # rad/s, of the gyro
    scale: float  # relative, of the gyro
    renewal: float  # s
    phase: float  # s, of the first renewal


@dataclass(frozen=True)
class Seen:
    """A tick as whoever hears the node reads it."""

    time: float  # s
    angle: float  # rad
    rate: float  # rad/s


def seen(readings: Readings, time: float) -> Seen:
    angle = (readings.count - ZERO) * 2 * np.pi / TURN
    return Seen(time, angle, -readings.gyro[1] * GYRO_STEP)


def draw_faults(rng: np.random.Generator) -> Faults:
    """A zero off by 1.5 deg, a bias of 3 deg/s; the gyro's scale and clock as in its data sheet."""
    zero, bias, scale = rng.standard_normal(3)
    return Faults(
        1.5 * DEGREE * zero,
        3 * DEGREE * bias,
        0.008 * scale,
        RENEWAL * (1 + 0.03 * rng.uniform(-1, 1)),
        rng.uniform(0.0, RENEWAL),
    )


def read(rng: np.random.Generator, faults: Faults, state: State, time: float) -> Readings:
    """The counts at that time [s]. The board's x axis points to the foot, z in extension."""
    age = (faults.phase + time) % faults.renewal
    angle = state.frame_angle + faults.zero + ENCODER_NOISE * rng.standard_normal()
    rate = state.frame_rate - age * state.frame_acceleration
    shown = (1 + faults.scale) * rate + faults.bias + GYRO_NOISE * rng.standard_normal()
    weight = GRAVITY * np.array([np.sin(state.frame_angle), 0.0, np.cos(state.frame_angle)])
    gyro = [0, -round(shown / GYRO_STEP), 0]
    acceleration = [round(each / ACCELERATION_STEP) for each in weight]
    return Readings((round(angle / (2 * np.pi) * TURN) + ZERO) % TURN, (*gyro,), (*acceleration,))
