"""Harmonics in the voluntary torque."""

import jax.numpy as jnp

from exoid.physics.moment import Moment
from exoid.physics.parameter import Parameter, parameter
from exoid.physics.term import Memory, PhysicsTerm, Scalar


class TorqueHarmonic(PhysicsTerm):
    """tau = -+tau_0 (s_2 sin 2a + c_2 (cos 2a - 1) + s_3 sin 3a + c_3 (cos 3a - 1)), a = 2 pi f t.

    The sign is that before the sine of Eq. 10.
    """

    title = "harmonics in the voluntary torque"
    reference = "Eq. 10 of the paper assumes a pure sine"
    explanation = (
        "The muscles do not push along the sine of Eq. 10: the torque has a second or third "
        "harmonic."
    )
    isolate = "passive drops for the leg, then the cycle by inverse dynamics"
    voluntary = True

    sine_3: Parameter = parameter("s_3", "1", -1.0, 1.0, "third harmonic, sine", (0.02,))
    sine_2: Parameter = parameter("s_2", "1", -1.0, 1.0, "second harmonic, sine", (0.0,))
    cosine_2: Parameter = parameter("c_2", "1", -1.0, 1.0, "second, cosine", (0.0,))
    cosine_3: Parameter = parameter("c_3", "1", -1.0, 1.0, "third, cosine", (0.0,))

    def torque(self, now: Moment, memory: Memory) -> Scalar:
        cycle = now.place.cycle
        at = cycle.phase(now.time)
        second = self.sine_2 * jnp.sin(2 * at) + self.cosine_2 * (jnp.cos(2 * at) - 1)
        third = self.sine_3 * jnp.sin(3 * at) + self.cosine_3 * (jnp.cos(3 * at) - 1)
        return cycle.amplitude * cycle.side(now.time) * (second + third)
