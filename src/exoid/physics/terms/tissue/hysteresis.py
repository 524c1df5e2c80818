"""Hysteresis that does not depend on speed (Bouc-Wen)."""

import jax.numpy as jnp

from exoid.physics.moment import CARRIED, Moment
from exoid.physics.parameter import Parameter, parameter
from exoid.physics.term import Memory, PhysicsTerm, Scalar

SHARPEST = 0.009  # rad, yield angle below which it is dry friction whose contacts bend first


class Hysteresis(PhysicsTerm):
    """tau = -F z,  z' = (phi' - (|phi'| z + phi' |z|) / 2) / phi_y.

    Of nine joints that yield by Dahl's law instead, with an exponent of 1/2 or 1, the level comes
    out to 1.3 % (root mean square), and the yield angle a fifth to a quarter too small.
    """

    title = "hysteresis (short-range stiffness, Bouc-Wen)"
    reference = "Wen, J Eng Mech Div 102(2), 1976; De Groote et al., PLoS ONE, 2018"
    explanation = (
        "The joint is stiff for the first degrees of every reversal and then yields, as cross-"
        "bridges, straps and pre-sliding bearings do."
    )
    isolate = "small reversals, and a drop right after the leg was shaken"
    isolate_driven = "slow reversals of several sizes"
    memory_size = 1
    lasting = True
    substeps = 4

    level: Parameter = parameter("F", "N m", 0.0, 50.0, "torque after yielding", (0.1,), law=0.015)
    yield_angle: Parameter = parameter(
        "phi_y", "rad", 0.004, 0.6, "yield angle", (0.03, 0.15), law=0.25
    )

    def includes(self) -> str:
        return "coulomb_friction" if self.yield_angle < SHARPEST else ""

    def itself(self) -> bool:
        return bool(self.yield_angle >= SHARPEST)

    def torque(self, now: Moment, memory: Memory) -> Scalar:
        return -self.level * memory[0]

    def memory_rate(self, now: Moment, memory: Memory) -> Memory:
        return loaded(now, memory, 1.0, self.yield_angle)

    def memory_within(self, now: Moment, memory: Memory) -> Memory:
        return jnp.clip(memory, -1.0, 1.0)


def loaded(now: Moment, memory: Memory, shape: Scalar | float, yields: Scalar) -> Memory:
    """z' of a Bouc-Wen element that yields, or hardens, by its shape r.

    One that yields within less than a step has long done so, and would run away: it yields within
    half of one.
    """
    quicker = jnp.abs(now.angular_velocity) * now.place.step / (CARRIED * yields)
    speed = now.angular_velocity / jnp.maximum(quicker, 1.0)
    return (speed - (jnp.abs(speed) * memory + shape * speed * jnp.abs(memory)) / 2) / yields
