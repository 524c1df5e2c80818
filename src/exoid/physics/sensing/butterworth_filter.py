"""A sensor behind a Butterworth low-pass filter of second order."""

import jax.numpy as jnp

from exoid.physics.moment import Moment
from exoid.physics.parameter import Parameter, parameter
from exoid.physics.sensing.first_order_filter import SHORTEST, fed, smoothed
from exoid.physics.term import Memory, Reading, SensorTerm


class ButterworthFilter(SensorTerm):
    """One sensor shows y instead of x, where y'' t^2 / 2 + y' t + y = x: the gyro, or with t < 0
    the encoder. It comes t late, as of a corner frequency of 1 / (sqrt(2) pi t).

    Its memory is (y, t y').
    """

    title = "a sensor behind a Butterworth low-pass filter"
    reference = (
        "Butterworth, Wireless Engineer 7, 1930; Winter, Biomechanics and Motor Control, 2009"
    )
    explanation = (
        "The gyro (the encoder, where the delay is below 0) is smoothed by a filter that runs "
        "forwards only, as in a device while it records, and the other sensor is not."
    )
    isolate = "quick movements by hand; the filter shows without any leg model"
    named_only = True
    memory_size = 2

    delay: Parameter = parameter(
        "t", "s", -0.1, 0.1, "delay (below 0 the encoder's)", (0.03, -0.03)
    )

    def shown(self, now: Moment, memory: Memory) -> Reading:
        return smoothed(self.delay, memory[0], now)

    def memory_at_rest(self, now: Moment) -> Memory:
        return jnp.stack([fed(self.delay, now), jnp.zeros(())])

    def memory_rate(self, now: Moment, memory: Memory) -> Memory:
        value, slope = memory
        late = jnp.maximum(abs(self.delay), SHORTEST)
        return jnp.stack([slope, 2 * (fed(self.delay, now) - value - slope)]) / late
