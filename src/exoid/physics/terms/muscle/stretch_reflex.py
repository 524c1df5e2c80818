"""Muscle that contracts when it is stretched fast, a moment later."""

from math import radians
from types import MappingProxyType

import jax.numpy as jnp

from exoid.physics.moment import Moment
from exoid.physics.parameter import Parameter, parameter
from exoid.physics.term import Memory, PhysicsTerm, Scalar

STAGES = 4  # of the delay: as many lags in a row
CARRIED = 2.2  # of a lag's rate times the step: less than of one, as they feed the leg in a row


class StretchReflex(PhysicsTerm):
    """tau = g a,  t_r a' = max(0, -v - v_th) - a, where v is phi' delayed by t_d.

    The delay is a row of lags; its memory are their outputs, and a. Of 24 legs that answer after a
    pure delay, another lag or a mean over a window, gain and threshold come out to 2 %; of three
    whose muscle rises by two lags of 35 ms, to 3 to 8 % and 2 to 5 %. Of 54 that answer so, or the
    more the longer the muscle is, or from a threshold on that falls with its length, and whose fit
    leaves noise alone, the angle at which the spring is slack comes out to 1.5 deg.
    """

    title = "stretch reflex"
    reference = "Kim, Eom & Hase, J Biomech 44(3), 2011; Falisse et al., 2018"
    explanation = (
        "The quadriceps contracts a few hundredths of a second after it was stretched faster than "
        "a threshold: only while flexing, only when fast."
    )
    isolate = "drops from several angles, so that only some pass the threshold; EMG"
    remark = "the torque comes after the delay and the rise time together"
    living = True
    substeps = 4  # at 25 Hz a delay of 0.02 s is carried
    memory_size = STAGES + 1
    law_of = MappingProxyType(
        {"stiffness_rest_angle.rest_angle": radians(1.5), "torque_bias.bias_over_inertia": 0.16}
    )  # rad, 1/s^2: of a spring of 6 1/s^2

    gain: Parameter = parameter("g", "N m s/rad", 0.0, 10.0, "reflex gain", (0.1,), law=0.06)
    threshold: Parameter = parameter(
        "v_th", "rad/s", 0.0, 8.0, "threshold of speed", (0.5, 2.0), law=0.04
    )
    delay: Parameter = parameter("t_d", "s", 0.004, 0.15, "delay", (0.045,), law=0.15)
    rise: Parameter = parameter(
        "t_r", "s", 0.004, 0.15, "rise time of the torque", (0.03,), law=0.3
    )

    def torque(self, now: Moment, memory: Memory) -> Scalar:
        return self.gain * memory[STAGES]

    def memory_rate(self, now: Moment, memory: Memory) -> Memory:
        before = jnp.concatenate([now.angular_velocity[None], memory[: STAGES - 1]])
        shortest = now.place.step / CARRIED
        passing = (before - memory[:STAGES]) / jnp.maximum(self.delay / STAGES, shortest)
        stretched = jnp.maximum(0.0, -memory[STAGES - 1] - self.threshold)
        return jnp.append(passing, (stretched - memory[STAGES]) / jnp.maximum(self.rise, shortest))
