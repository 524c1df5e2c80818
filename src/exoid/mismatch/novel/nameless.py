"""Simple torques that the library does not name: what has a name may only stand in for them.

Damping that saturates passes for dry friction, damping that depends on the angle for drag, a muscle
that lets go after the release for relaxing tissue.
"""

import jax.numpy as jnp

from exoid.physics.moment import Moment
from exoid.physics.parameter import Parameter, parameter
from exoid.physics.term import Memory, PhysicsTerm, Scalar, Term

SLOW = 0.01  # rad/s, below which saturating damping is in proportion to the rate
STILL = 0.1  # rad/s, below which friction that fades is in proportion to the rate
LATE = (0.1, 10.0)  # s, within which something fades


def halfway(lowest: float, highest: float) -> tuple[float, ...]:
    """The middle of a motion [rad]."""
    return ((lowest + highest) / 2,)


class DampingByAngle(PhysicsTerm):
    """tau = -k phi phi'."""

    title = "damping that changes with the angle"
    reference = "assumed: the first power of the angle"
    explanation = "The leg is damped more at one end of its range than at the other."
    isolate = "small swings about several angles, by added masses or another tilt of the thigh"
    isolate_rig = "small swings about several angles, by added masses or another tilt of the base"
    isolate_driven = "slow and fast movements about several angles"

    by_angle: Parameter = parameter("k", "N m s/rad^2", -2.0, 2.0, "damping per angle", (0.0,))

    def torque(self, now: Moment, memory: Memory) -> Scalar:
        return -self.by_angle * now.angle * now.angular_velocity


class DampingFromTheMiddle(PhysicsTerm):
    """tau = -k (phi - phi_m)^2 phi'."""

    title = "damping that changes away from the middle of the swings"
    reference = "assumed: the second power of the angle"
    explanation = "The leg is damped otherwise about where it hangs than at the ends of its swings."
    isolate = DampingByAngle.isolate
    isolate_rig = DampingByAngle.isolate_rig
    isolate_driven = DampingByAngle.isolate_driven

    outward: Parameter = parameter("k", "N m s/rad^3", -5.0, 5.0, "damping outwards", (0.0,))
    middle: Parameter = parameter("phi_m", "rad", -4.0, 4.0, "where it changes least", halfway)

    def torque(self, now: Moment, memory: Memory) -> Scalar:
        return -self.outward * (now.angle - self.middle) ** 2 * now.angular_velocity


class DampingByDirection(PhysicsTerm):
    """tau = -k |phi'|."""

    title = "damping that differs by direction"
    reference = "assumed: two coefficients, one for each direction"
    explanation = "Flexion is damped more, or less, than extension."
    isolate = "drops with surface electrodes on the muscles, which tell of one that is at work"
    isolate_rig = "drops from either side of where the rig hangs, from large and small angles"
    isolate_driven = "constant speeds, slow and fast, both ways"

    by_direction: Parameter = parameter("k", "N m s/rad", -1.0, 1.0, "half the difference", (0.0,))

    def torque(self, now: Moment, memory: Memory) -> Scalar:
        return -self.by_direction * jnp.abs(now.angular_velocity)


class SaturatingDamping(PhysicsTerm):
    """tau = -k sgn(phi') (|phi'| / 1 rad/s)^(1/2), smooth about 0: it holds no leg."""

    title = "damping that grows slower than the rate"
    reference = "assumed: a power of the rate below the first"
    explanation = "Slow movement is damped more than in proportion; nothing holds the leg."
    isolate = "swings until the leg rests, with little noise: dry friction ends them short of rest"
    isolate_driven = "constant speeds, down to the slowest"

    saturating: Parameter = parameter("k", "N m", 0.0, 5.0, "torque at 1 rad/s", (0.0,))

    def torque(self, now: Moment, memory: Memory) -> Scalar:
        rate = now.angular_velocity
        return -self.saturating * rate / jnp.sqrt(jnp.abs(rate) + SLOW)


class FadingDamping(PhysicsTerm):
    """tau = -k exp(-t / T) phi', from the begin of every segment on."""

    title = "damping that fades after the release"
    reference = "thixotropy: Lakie, Walsh & Wright, J Physiol 353, 1984"
    explanation = "A leg that was held still is damped more at first, or ever more as it swings."
    isolate = "drops straight after some swings by hand, and after a minute's rest"
    isolate_driven = "the same movement straight after another, and after a minute's rest"

    fading_damping: Parameter = parameter("k", "N m s/rad", -50.0, 50.0, "at the begin", (0.0,))
    fading_time: Parameter = parameter("T", "s", *LATE, "time constant", (1.0,))

    def torque(self, now: Moment, memory: Memory) -> Scalar:
        faded = jnp.exp(-now.time / self.fading_time)
        return -self.fading_damping * faded * now.angular_velocity


class FadingFriction(PhysicsTerm):
    """tau = -k exp(-t / T) sgn(phi'), smooth about 0, from the begin of every segment on."""

    title = "friction that fades after the release"
    reference = FadingDamping.reference
    explanation = "What was held still resists at first, however slowly it is moved."
    isolate = FadingDamping.isolate
    isolate_driven = FadingDamping.isolate_driven

    fading_friction: Parameter = parameter("k", "N m", -10.0, 10.0, "at the begin", (0.0,))
    fading_slowly: Parameter = parameter("T", "s", *LATE, "time constant", (1.0,))

    def torque(self, now: Moment, memory: Memory) -> Scalar:
        rate = now.angular_velocity
        faded = jnp.exp(-now.time / self.fading_slowly)
        return -self.fading_friction * faded * rate / jnp.hypot(rate, STILL)


class FadingTorque(PhysicsTerm):
    """tau = k exp(-t / T), from the begin of every segment on."""

    title = "a torque that fades after the release"
    reference = "assumed: a muscle that lets go as a first-order system does"
    explanation = "A muscle, or what held the leg, lets go only after the release."
    isolate = "drops that are announced and drops that are not"
    isolate_rig = "drops after a hold of a second, and after one of a minute"
    isolate_driven = "the motor holding still, straight after it was switched on and later"

    fading_torque: Parameter = parameter("k", "N m", -100.0, 100.0, "at the begin", (0.0,))
    fading_while: Parameter = parameter("T", "s", *LATE, "time constant", (1.0,))

    def torque(self, now: Moment, memory: Memory) -> Scalar:
        return self.fading_torque * jnp.exp(-now.time / self.fading_while)


NAMELESS: frozenset[type[Term]] = frozenset(
    {
        DampingByAngle,
        DampingFromTheMiddle,
        DampingByDirection,
        SaturatingDamping,
        FadingDamping,
        FadingFriction,
        FadingTorque,
    }
)
