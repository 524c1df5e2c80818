"""A muscle that follows its command late."""

from exoid.physics.moment import Moment
from exoid.physics.parameter import Parameter, parameter
from exoid.physics.term import Memory, PhysicsTerm, Scalar


class ActivationLag(PhysicsTerm):
    """The torque is a in place of tau_h,  a' = (tau_h - a) / t_a. Its memory is a."""

    title = "the muscle follows its command late"
    reference = "Zajac, Crit Rev Biomed Eng 17(4), 1989; Thelen, J Biomech Eng, 2003"
    explanation = (
        "Activation takes time, so that the torque of Eq. 10 arrives late and rounded; a delay "
        "or an early clock of the torque look the same."
    )
    isolate = "EMG, or a metronome on the recording's own clock"
    memory_size = 1
    substeps = 4
    voluntary = True

    lag: Parameter = parameter("t_a", "s", 0.001, 0.4, "activation time", (0.005, 0.05))

    def torque(self, now: Moment, memory: Memory) -> Scalar:
        return memory[0] - now.place.cycle.torque(now.time)

    def memory_at_rest(self, now: Moment) -> Memory:
        return now.place.cycle.torque(now.time)[None]

    def memory_rate(self, now: Moment, memory: Memory) -> Memory:
        return (now.place.cycle.torque(now.time)[None] - memory) / self.lag
