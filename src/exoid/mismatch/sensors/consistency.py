"""Do encoder and gyro agree with each other? No leg model is needed to tell.

What only a sensor can have done is seen here first, so that no torque is ever blamed for it.
"""

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from exoid.fitting.data.observation import Observation
from exoid.mismatch.sensors.smooth import (
    JERKS,
    Reference,
    Samples,
    Smoother,
    smooth,
    smoothed,
    smoother_of,
)
from exoid.physics.sensing.gyro_bias import GyroBias
from exoid.physics.sensing.gyro_scale import GyroScale
from exoid.physics.sensing.sensor_skew import SensorSkew
from exoid.physics.term import name_of

BIAS, DELAY = name_of(GyroBias), name_of(SensorSkew)
ERRORS = (name_of(GyroScale), BIAS, DELAY)  # in the order of the columns
UNITS = ("1", "rad/s", "s")
ROUNDS = 3  # a late gyro is shifted by what the last round found
CLEAR = 25.0  # sum of squares that an error must explain to be one: 5 standard deviations


@dataclass(frozen=True, eq=False)
class SensorError:
    """What the gyro does against the encoder."""

    name: str
    value: float
    standard_error: float
    unit: str

    @property
    def clear(self) -> bool:
        return self.value**2 > CLEAR * self.standard_error**2


@dataclass(frozen=True, eq=False)
class Consistency:
    """The sensors against each other, and the motion that they show together."""

    errors: list[SensorError]  # empty without a gyro
    references: list[Reference]

    @property
    def delay(self) -> float:
        """By which the gyro clearly is late [s], else 0."""
        known = [each.value for each in self.errors if each.name == DELAY and each.clear]
        return known[0] if known else 0.0


def consistency(seen: Observation) -> Consistency:
    """Compare encoder and gyro over all segments; samples of weight 0 were not measured."""
    segments = [segment(seen, number) for number in range(seen.time.shape[0])]
    if not any(weights[:, 1].any() for _, _, weights in segments):
        return Consistency([], [smooth(*each) for each in segments])
    total, covariance, misfit = np.zeros(len(ERRORS)), np.zeros((3, 3)), 1.0
    motions = [smooth(time, data, weights * [1.0, 0.0]) for time, data, weights in segments]
    for _ in range(ROUNDS):
        cleaned = [
            (time, corrected(time, data, motion, total), weights)
            for (time, data, weights), motion in zip(segments, motions, strict=True)
        ]
        change, covariance, misfit, smoothers = compared(cleaned, motions)
        total = total + change
        motions = [
            smoothed(smoother, corrected(time, data, motion, total))
            for (time, data, _), motion, smoother in zip(segments, motions, smoothers, strict=True)
        ]
    errors = [
        SensorError(name, float(value), float(np.sqrt(variance)), unit)
        for name, value, variance, unit in zip(
            ERRORS, total, np.diag(covariance), UNITS, strict=True
        )
    ]
    found = np.array([each.value if each.clear else 0.0 for each in errors])
    excess = float(np.sqrt(max(1.0, misfit)))  # of what remains between the sensors
    references = [
        smooth(time, corrected(time, data, motion, found), weights / [1.0, excess])
        for (time, data, weights), motion in zip(segments, motions, strict=True)
    ]
    return Consistency(errors, references)


def segment(seen: Observation, number: int) -> tuple[Samples, np.ndarray, np.ndarray]:
    """Time, data and weights of one segment, without the rows that fill up its shape."""
    each = (seen.angle_weight[number], seen.velocity_weight[number])
    weights = np.stack([np.asarray(one) for one in each], axis=1)
    count = int(np.flatnonzero(weights.any(axis=1))[-1]) + 1
    data = np.stack([seen.angle[number], seen.angular_velocity[number]], axis=1)
    return np.asarray(seen.time[number])[:count], data[:count], weights[:count]


def corrected(time: Samples, data: np.ndarray, motion: Reference, errors: np.ndarray) -> np.ndarray:
    """The data as a right gyro would have shown them."""
    scale, bias, delay = errors
    velocity = motion.angular_velocity
    shown = (1 + scale) * np.interp(time - delay, time, velocity) + bias
    return np.stack([data[:, 0], data[:, 1] - shown + velocity], axis=1)


def compared(
    cleaned: list[tuple[np.ndarray, ...]], motions: list[Reference]
) -> tuple[np.ndarray, np.ndarray, float, list[Smoother]]:
    """The gyro's errors by least squares, their covariance, the misfit left a sample, and what
    smoothed the segments.
    """
    best = None
    for jerk in JERKS:
        made = [smoother_of(time, weights, float(jerk)) for time, _, weights in cleaned]
        smoothers = [each for each in made if each is not None]
        if len(smoothers) < len(made):
            continue
        normal, gradient = np.zeros((3, 3)), np.zeros(3)
        square = likelihood = 0.0
        for (_, data, _), motion, smoother in zip(cleaned, motions, smoothers, strict=True):
            rows = smoother.left(np.concatenate([data[:, :, None], columns(motion)], axis=2))
            product = rows.T @ rows
            square += product[0, 0]
            gradient += product[0, 1:]
            normal += product[1:, 1:]
            spread = float(np.sum(np.log(smoother.factor[-1])))
            likelihood += -spread - 3 * smoother.log_scale
        change = np.linalg.solve(normal, gradient)
        likelihood -= (square - gradient @ change) / 2
        if best is None or likelihood > best[0]:
            best = (likelihood, change, normal, square - gradient @ change, smoothers)
    assert best is not None  # there are jerks to try
    _, change, normal, misfit, smoothers = best
    samples = sum((weights > 0).sum() for _, _, weights in cleaned) / 2
    return change, np.linalg.inv(normal), float(misfit / samples), smoothers


def columns(motion: Reference) -> Float[np.ndarray, "sample 2 error"]:
    """What unit errors of the gyro add to the data."""
    velocity, acceleration = motion.angular_velocity, motion.angular_acceleration
    each = np.stack([velocity, np.ones_like(velocity), -acceleration], axis=1)
    return np.stack([np.zeros_like(each), each], axis=1)
