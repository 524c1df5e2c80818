"""A magnet that is off the encoder's centre."""

import math

import jax.numpy as jnp

from exoid.physics.moment import Moment
from exoid.physics.parameter import Parameter, parameter
from exoid.physics.term import Memory, Reading, SensorTerm, reading


class EncoderEccentricity(SensorTerm):
    """The encoder shows phi + A_s sin(phi) + A_c cos(phi)."""

    title = "magnet off the encoder's centre"
    reference = "AS5600 datasheet: about 1 deg within 0.5 mm off centre"
    explanation = (
        "The magnet does not sit over the middle of the chip, so that the angle is stretched in "
        "one part of the turn and shrunk in another."
    )
    isolate = "a full turn of the hinge on the bench, or the magnet turned by 90 deg"
    period = 2 * math.pi

    sine: Parameter = parameter("A_s", "rad", -0.15, 0.15, "in phase", (0.01,))
    cosine: Parameter = parameter("A_c", "rad", -0.15, 0.15, "in quadrature", (0.01,))

    def shown(self, now: Moment, memory: Memory) -> Reading:
        error = self.sine * jnp.sin(now.angle) + self.cosine * jnp.cos(now.angle)
        return reading(error)
