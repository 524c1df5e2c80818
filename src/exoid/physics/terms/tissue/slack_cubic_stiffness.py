"""A spring that hardens away from where it is slack, in a bent position."""

from exoid.physics.moment import Moment
from exoid.physics.parameter import Parameter, parameter
from exoid.physics.term import Memory, PhysicsTerm, Scalar
from exoid.physics.terms.tissue.cubic_stiffness import CubicStiffness


class SlackCubicStiffness(PhysicsTerm):
    """tau = -k_3 (phi - phi_3)^3, hardening where k_3 > 0."""

    title = "stiffness that grows with the cube of the angle from where it is slack"
    reference = CubicStiffness.reference
    explanation = (
        "The spring hardens (or softens) away from a bent position, so that the leg swings the "
        "faster the farther it is from there."
    )
    isolate = CubicStiffness.isolate
    isolate_driven = CubicStiffness.isolate_driven
    by_whole_drops = True

    coefficient: Parameter = parameter("k_3", "N m/rad^3", -3.0, 10.0, "cubic stiffness", (0.2,))
    slack_angle: Parameter = parameter("phi_3", "rad", -1.6, 0.3, "where it is slack", (-0.6,))

    def torque(self, now: Moment, memory: Memory) -> Scalar:
        return -self.coefficient * (now.angle - self.slack_angle) ** 3
