"""Stiffness that changes with amplitude."""

from exoid.physics.moment import Moment
from exoid.physics.parameter import Parameter, parameter
from exoid.physics.term import Memory, PhysicsTerm, Scalar


class CubicStiffness(PhysicsTerm):
    """tau = -k_3 phi^3, hardening where k_3 > 0."""

    title = "stiffness that grows with the cube of the angle"
    reference = "Lin & Rymer, IEEE TBME 38(9), 1991; Oatis, Phys Ther 73(11), 1993"
    explanation = (
        "The spring hardens (or softens) with its stretch, so that the period depends on the "
        "amplitude by more than gravity's share. A spring that spans a rig's axis from above or "
        "below looks like it: what of its pull goes with the cosine of the angle is in m l g."
    )
    isolate = "drops from several angles, with an encoder checked at a known angle"
    isolate_driven = "slow movements through the whole range, both ways"
    by_whole_drops = True

    coefficient: Parameter = parameter("k_3", "N m/rad^3", -3.0, 10.0, "cubic stiffness", (0.2,))

    def torque(self, now: Moment, memory: Memory) -> Scalar:
        return -self.coefficient * now.angle**3
