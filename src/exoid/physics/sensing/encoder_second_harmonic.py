"""An encoder that errs twice per turn."""

import math

import jax.numpy as jnp

from exoid.physics.moment import Moment
from exoid.physics.parameter import Parameter, parameter
from exoid.physics.term import Memory, Reading, SensorTerm, reading


class EncoderSecondHarmonic(SensorTerm):
    """The encoder shows phi + B_s sin(2 phi) + B_c cos(2 phi)."""

    title = "encoder that errs twice per turn"
    reference = "Monolithic Power AN142: field components of unequal size"
    explanation = (
        "The two components of the magnet's field are not equally strong where the chip sits (a "
        "tilted magnet, iron nearby), so that the angle is stretched and shrunk twice per turn. A "
        "camera that does not look squarely at the leg's plane does the same."
    )
    isolate = "a full turn of the hinge on the bench, with iron and magnets far away"
    period = math.pi

    sine: Parameter = parameter("B_s", "rad", -0.1, 0.1, "in phase", (0.01,))
    cosine: Parameter = parameter("B_c", "rad", -0.1, 0.1, "in quadrature", (0.01,))

    def shown(self, now: Moment, memory: Memory) -> Reading:
        error = self.sine * jnp.sin(2 * now.angle) + self.cosine * jnp.cos(2 * now.angle)
        return reading(error)
