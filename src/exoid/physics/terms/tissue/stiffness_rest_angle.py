"""A spring that is slack elsewhere than at full extension."""

from math import radians
from typing import Any

from exoid.physics.moment import Moment
from exoid.physics.parameter import Parameter, parameter
from exoid.physics.term import Memory, PhysicsTerm, Scalar

OVEREXTENDED = radians(15.0)  # rad, beyond which hardly any knee extends, and none is slack


class StiffnessRestAngle(PhysicsTerm):
    """tau = c phi_r, so that the spring is -c (phi - phi_r)."""

    title = "rest angle of the passive stiffness"
    reference = "Riener & Edrich, J Biomech 32(5), 1999"
    explanation = (
        "The spring of a relaxed knee, or of a rig, is slack at another angle than full extension, "
        "where Eq. 9 has it. One that hangs from above or below the axis pulls with the cosine of "
        "the angle, as gravity does: m l g then holds that pull, too, and no motion parts them."
    )
    isolate = "the hanging angle without and with a known added mass"
    isolate_driven = "the angle at which the axis rests with the motor off"

    steady = True
    same_torque = "torque_bias"

    rest_angle: Parameter = parameter(
        "phi_r", "rad", -2.0, 1.5, "rest angle of the spring", (-0.3,)
    )

    @staticmethod
    def as_same_torque(size: Any, stiffness: Any) -> Any:
        return size * stiffness

    def possible(self) -> bool:
        return float(self.rest_angle) < OVEREXTENDED

    def torque(self, now: Moment, memory: Memory) -> Scalar:
        return now.stiffness * self.rest_angle
