"""Hysteresis of any shape (Bouc-Wen with three parameters)."""

import jax.numpy as jnp

from exoid.physics.moment import Moment
from exoid.physics.parameter import Parameter, parameter
from exoid.physics.term import Memory, PhysicsTerm, Scalar
from exoid.physics.terms.tissue.hysteresis import loaded

FARTHEST = 1e3  # of z, where it does not yield


class ShapedHysteresis(PhysicsTerm):
    """tau = -F z,  z' = (phi' - (|phi'| z + r phi' |z|) / 2) / phi_y,  z_0 at the first sample.

    r = 1 yields while it is loaded (`Hysteresis`), r = 0 loads along a line, r < 0 hardens.
    """

    title = "hysteresis that yields or hardens (Bouc-Wen)"
    reference = "Wen, J Eng Mech Div 102(2), 1976; Noel & Schoukens, Bouc-Wen benchmark, 2016"
    explanation = (
        "A spring of the rig loses energy in every reversal, however slow it is, as bolted joints, "
        "rubber and wire ropes do."
    )
    isolate = "slow reversals of several sizes, and a pull to one side held still"
    memory_size = 1
    lasting = True
    begun = "load"
    substeps = 4
    mechanical = True

    level: Parameter = parameter("F", "N m", 0.0, 50.0, "torque of the spring at phi_y", (1.0,))
    yield_angle: Parameter = parameter("phi_y", "rad", 0.004, 0.6, "yield angle", (0.2,))
    shape: Parameter = parameter(
        "r", "1", -2.0, 1.0, "yielding (1) or hardening (< 0)", (0.0,), plain=1.0
    )
    load: Parameter = parameter("z_0", "1", -5.0, 5.0, "load at the first sample", (0.0,))

    def memory_at_rest(self, now: Moment) -> Memory:
        return jnp.reshape(self.load, 1)

    def torque(self, now: Moment, memory: Memory) -> Scalar:
        return -self.level * memory[0]

    def memory_rate(self, now: Moment, memory: Memory) -> Memory:
        return loaded(now, memory, self.shape, self.yield_angle)

    def memory_within(self, now: Moment, memory: Memory) -> Memory:
        farthest = 2 / jnp.maximum(1 + self.shape, 2 / FARTHEST)
        return jnp.clip(memory, -farthest, farthest)
