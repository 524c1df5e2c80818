"""A spring and a damper in series: tissue that relaxes."""

from exoid.physics.moment import Moment
from exoid.physics.parameter import Parameter, parameter
from exoid.physics.term import Memory, PhysicsTerm, Scalar


class MaxwellElement(PhysicsTerm):
    """tau = -k_1 (phi - z),  z' = (phi - z) / t_r. Its memory is phi - z."""

    title = "tissue that relaxes (Maxwell element)"
    reference = "Fung, Biomechanics: Mechanical Properties of Living Tissues, 1993"
    explanation = (
        "Tendon and muscle resist a quick stretch and give way to a lasting one, so that stiffness "
        "and damping depend on how fast the leg swings."
    )
    isolate = "holds of 1, 10 and 60 s before the release; swings at two periods"
    living = True
    memory_size = 1
    lasting = True

    stiffness: Parameter = parameter(
        "k_1", "N m/rad", 0.0, 30.0, "stiffness of the element", (0.5,)
    )
    relaxation_time: Parameter = parameter(
        "t_r", "s", 0.02, 10.0, "relaxation time", (0.08, 0.4, 2.0)
    )

    def torque(self, now: Moment, memory: Memory) -> Scalar:
        return -self.stiffness * memory[0]

    def memory_rate(self, now: Moment, memory: Memory) -> Memory:
        return (now.angular_velocity - memory[0] / self.relaxation_time)[None]
