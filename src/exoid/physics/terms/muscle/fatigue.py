"""Strength and damping that change as the session goes on."""

from exoid.physics.moment import Moment
from exoid.physics.parameter import Parameter, parameter
from exoid.physics.term import Memory, PhysicsTerm, Scalar


class Fatigue(PhysicsTerm):
    """tau = -n x_d d phi' - x_tau tau_h (t - t0) / T: from segment to segment, and within a cycle.

    n counts the segments from 0. How strong each cycle is the fit finds by itself.
    """

    title = "fatigue or warming up from segment to segment"
    reference = "engineering estimate: 1-10 % per cycle"
    explanation = (
        "Damping rises or falls from one segment to the next, or the push fades within a cycle, as "
        "tissue warms up and muscles tire."
    )
    isolate = "the same drop at the beginning and at the end of the session"
    living = True

    damping_drift: Parameter = parameter(
        "x_d", "1", -0.3, 1.0, "damping, change per segment", (0.03,)
    )
    fade: Parameter = parameter("x_tau", "1", -1.0, 1.0, "fade within a cycle", (0.02,))

    def torque(self, now: Moment, memory: Memory) -> Scalar:
        cycle = now.place.cycle
        damping = now.place.number * self.damping_drift * now.damping
        run = (now.time - cycle.onset) / cycle.period
        return -damping * now.angular_velocity - self.fade * cycle.torque(now.time) * run
