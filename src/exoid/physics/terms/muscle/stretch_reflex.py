"""Muscle that contracts when it is stretched fast, a moment later."""

import jax.numpy as jnp

from exoid.physics.moment import CARRIED, Moment
from exoid.physics.parameter import Parameter, parameter
from exoid.physics.term import Memory, PhysicsTerm, Scalar

STAGES = 4  # of the delay: as many lags in a row
RISE = 0.03  # s, in which the muscle's torque follows
LAG = f"before a lag of {RISE:g} s"


class StretchReflex(PhysicsTerm):
    """tau = g a,  0.03 s a' = max(0, -v - v_th) - a, where v is phi' delayed by t_d.

    The delay is a row of lags; its memory are their outputs, and a.
    """

    title = "stretch reflex"
    reference = "Kim, Eom & Hase, J Biomech 44(3), 2011; Falisse et al., 2018"
    explanation = (
        "The quadriceps contracts a few hundredths of a second after it was stretched faster than "
        "a threshold: only while flexing, only when fast."
    )
    isolate = "drops from several angles, so that only some pass the threshold; EMG"
    remark = f"the delay is that {LAG}, in which the torque follows: in all it is the sum"
    living = True
    substeps = 4  # at 25 Hz a delay of 0.02 s is carried
    memory_size = STAGES + 1

    gain: Parameter = parameter("g", "N m s/rad", 0.0, 10.0, "reflex gain", (0.1,))
    threshold: Parameter = parameter("v_th", "rad/s", 0.0, 8.0, "threshold of speed", (0.5, 2.0))
    delay: Parameter = parameter("t_d", "s", 0.004, 0.15, f"delay {LAG}", (0.045,))

    def torque(self, now: Moment, memory: Memory) -> Scalar:
        return self.gain * memory[STAGES]

    def memory_rate(self, now: Moment, memory: Memory) -> Memory:
        before = jnp.concatenate([now.angular_velocity[None], memory[: STAGES - 1]])
        shortest = STAGES * now.place.step / CARRIED
        passing = (before - memory[:STAGES]) * (STAGES / jnp.maximum(self.delay, shortest))
        stretched = jnp.maximum(0.0, -memory[STAGES - 1] - self.threshold)
        return jnp.append(passing, (stretched - memory[STAGES]) / RISE)
