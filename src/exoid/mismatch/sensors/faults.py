"""What encoder and gyro can do wrong against each other, each by what it adds to the gyro's rate.

The motion is the one that the encoder shows: where that errs, the gyro seems to err the other way.
What drifts slowly is taken out before (`recordings/signal/both_sensors`).
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from exoid.mismatch.sensors.smooth import Reference
from exoid.physics.sensing.encoder_eccentricity import EncoderEccentricity
from exoid.physics.sensing.encoder_second_harmonic import EncoderSecondHarmonic
from exoid.physics.sensing.gyro_bias import GyroBias
from exoid.physics.sensing.gyro_scale import GyroScale
from exoid.physics.sensing.sensor_skew import SensorSkew
from exoid.physics.term import Term, name_of

Columns = Float[np.ndarray, "sample parameter"]


@dataclass(frozen=True)
class Fault:
    """A term of the library, and the rate [rad/s] that a unit of each of its parameters adds."""

    term: type[Term]
    parameters: int
    columns: Callable[[Reference], Columns]

    @property
    def name(self) -> str:
        return name_of(self.term)


def scaled(motion: Reference) -> Columns:
    return motion.angular_velocity[:, None]


def biased(motion: Reference) -> Columns:
    return np.ones((motion.angle.size, 1))


def late(motion: Reference) -> Columns:
    return -motion.angular_acceleration[:, None]


def turned(order: int) -> Callable[[Reference], Columns]:
    """-d/dt of (sin(order phi), cos(order phi)), which an encoder adds to what it shows."""

    def columns(motion: Reference) -> Columns:
        waves = np.stack([-np.cos(order * motion.angle), np.sin(order * motion.angle)], axis=1)
        return order * waves * motion.angular_velocity[:, None]

    return columns


SCALE = Fault(GyroScale, 1, scaled)
BIAS = Fault(GyroBias, 1, biased)
SKEW = Fault(SensorSkew, 1, late)
ECCENTRIC = Fault(EncoderEccentricity, 2, turned(1))
TWICE = Fault(EncoderSecondHarmonic, 2, turned(2))
USUAL = (SCALE, BIAS, SKEW)  # of every gyro
OTHERS = (ECCENTRIC, TWICE)  # of an encoder
