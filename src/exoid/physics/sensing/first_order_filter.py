"""A sensor behind a low-pass filter of first order."""

import jax.numpy as jnp

from exoid.physics.moment import Moment
from exoid.physics.parameter import Parameter, parameter
from exoid.physics.term import Memory, Reading, Scalar, SensorTerm, reading

# s, which steps of 0.02 s can follow: a filter that is quicker shows as much less of this one.
SHORTEST = 0.015


class FirstOrderFilter(SensorTerm):
    """One sensor shows y instead of x, where T y' = x - y: the gyro, or with T < 0 the encoder.

    Its memory is y.
    """

    title = "a sensor behind a low-pass filter of first order"
    reference = "LSM6DS3 datasheet: LPF1 of the gyro; exponential smoothing in software"
    explanation = (
        "The gyro (the encoder, where the lag is below 0) is smoothed by a filter that the other "
        "sensor does not have: it comes later, and quick movements smaller."
    )
    isolate = "quick movements by hand; the filter shows without any leg model"
    named_only = True
    memory_size = 1

    lag: Parameter = parameter(
        "T", "s", -0.1, 0.1, "time constant (below 0 the encoder's)", (0.03, -0.03)
    )

    def shown(self, now: Moment, memory: Memory) -> Reading:
        return smoothed(self.lag, memory[0], now)

    def memory_at_rest(self, now: Moment) -> Memory:
        return fed(self.lag, now)[None]

    def memory_rate(self, now: Moment, memory: Memory) -> Memory:
        return (fed(self.lag, now) - memory) / jnp.maximum(abs(self.lag), SHORTEST)


def fed(lag: Scalar, now: Moment) -> Scalar:
    """What a filter smooths: the gyro's rate, or with a negative lag the encoder's angle."""
    return jnp.where(lag > 0, now.angular_velocity, now.angle)


def smoothed(lag: Scalar, value: Scalar, now: Moment) -> Reading:
    """What the sensors show where a filter gives this value."""
    behind = (value - fed(lag, now)) * jnp.minimum(abs(lag) / SHORTEST, 1.0)
    return reading(jnp.where(lag > 0, 0.0, behind), jnp.where(lag > 0, behind, 0.0))
