"""Stiffness that changes with amplitude."""

from typing import Any, ClassVar

from jaxtyping import Array, Float

from exoid.physics.moment import Moment
from exoid.physics.parameter import parameter
from exoid.physics.term import Memory, PhysicsTerm


class CubicStiffness(PhysicsTerm):
    """tau = -k_3 phi^3, hardening where k_3 > 0."""

    title: ClassVar[str] = "stiffness that grows with the cube of the angle"
    reference: ClassVar[str] = "Lin & Rymer, IEEE TBME 38(9), 1991; Oatis, Phys Ther 73(11), 1993"
    explanation: ClassVar[str] = (
        "The spring hardens (or softens) with its stretch, so that the period depends on the "
        "amplitude by more than gravity's share."
    )
    isolate: ClassVar[str] = "drops from several angles, with an encoder checked at a known angle"

    coefficient: Float[Any, ""] = parameter(
        "k_3", "N m/rad^3", -3.0, 10.0, "cubic stiffness", (0.2,)
    )

    def torque(self, now: Moment, memory: Memory) -> Float[Array, ""]:
        return -self.coefficient * now.angle**3
