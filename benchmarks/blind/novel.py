"""Torques that exoid's library does not hold: what is concealed in the cases called novel."""

from typing import Any, ClassVar

import jax.numpy as jnp
from jaxtyping import Array, Float

from exoid.physics.moment import Moment
from exoid.physics.parameter import parameter
from exoid.physics.term import Memory, PhysicsTerm

REFERENCE = "invented for this benchmark"
ISOLATE = "not known: no library holds it"


class AngleBump(PhysicsTerm):
    """tau = s exp(-((phi - phi_b) / w)^2): something is run over in the middle of the range."""

    title: ClassVar[str] = "a bump at one angle"
    reference: ClassVar[str] = REFERENCE
    explanation: ClassVar[str] = "The leg is pushed the same way whenever it passes one angle."
    isolate: ClassVar[str] = ISOLATE

    height: Float[Any, ""] = parameter("s", "N m", -5.0, 5.0, "height")
    angle: Float[Any, ""] = parameter("phi_b", "rad", -2.0, 0.0, "where")
    width: Float[Any, ""] = parameter("w", "rad", 0.05, 0.5, "width")

    def torque(self, now: Moment, memory: Memory) -> Float[Array, ""]:
        return self.height * jnp.exp(-(((now.angle - self.angle) / self.width) ** 2))


class MagneticDetent(PhysicsTerm):
    """tau = s sin(k (phi - phi_0)): a hinge with magnets, which prefers some angles."""

    title: ClassVar[str] = "a detent that repeats with the angle"
    reference: ClassVar[str] = REFERENCE
    explanation: ClassVar[str] = "The hinge prefers angles that lie evenly apart."
    isolate: ClassVar[str] = ISOLATE

    height: Float[Any, ""] = parameter("s", "N m", 0.0, 5.0, "height")
    waves: Float[Any, ""] = parameter("k", "1", 4.0, 20.0, "periods in a turn")
    angle: Float[Any, ""] = parameter("phi_0", "rad", -2.0, 2.0, "an angle without torque")

    def torque(self, now: Moment, memory: Memory) -> Float[Array, ""]:
        return self.height * jnp.sin(self.waves * (now.angle - self.angle))


class AngleDamping(PhysicsTerm):
    """tau = s phi phi': damping that grows (s > 0) or fades (s < 0) towards flexion."""

    title: ClassVar[str] = "damping in proportion to the angle"
    reference: ClassVar[str] = REFERENCE
    explanation: ClassVar[str] = "The more the knee is bent, the more (or less) it is damped."
    isolate: ClassVar[str] = ISOLATE

    slope: Float[Any, ""] = parameter("s", "N m s/rad^2", -0.5, 2.0, "damping per angle")

    def torque(self, now: Moment, memory: Memory) -> Float[Array, ""]:
        return self.slope * now.angle * now.angular_velocity


class Kick(PhysicsTerm):
    """tau = s exp(-((t - t_k) / w)^2): a short push at the same time after every release."""

    title: ClassVar[str] = "a push at one time after the release"
    reference: ClassVar[str] = REFERENCE
    explanation: ClassVar[str] = "Somebody or something knocks against the leg, always as late."
    isolate: ClassVar[str] = ISOLATE

    height: Float[Any, ""] = parameter("s", "N m", -20.0, 20.0, "height")
    moment: Float[Any, ""] = parameter("t_k", "s", 0.1, 3.0, "when")
    width: Float[Any, ""] = parameter("w", "s", 0.01, 0.3, "width")

    def torque(self, now: Moment, memory: Memory) -> Float[Array, ""]:
        return self.height * jnp.exp(-(((now.time - self.moment) / self.width) ** 2))


class SnapWindow(PhysicsTerm):
    """tau = s x exp(-x^2) with x = (phi - phi_w) / w: a spring that pushes away from one angle."""

    title: ClassVar[str] = "a window of negative stiffness"
    reference: ClassVar[str] = REFERENCE
    explanation: ClassVar[str] = "Around one angle the leg is pushed away from it, as by a snap."
    isolate: ClassVar[str] = ISOLATE

    push: Float[Any, ""] = parameter("s", "N m", 0.0, 10.0, "push")
    angle: Float[Any, ""] = parameter("phi_w", "rad", -2.0, 0.0, "where")
    width: Float[Any, ""] = parameter("w", "rad", 0.05, 0.6, "width")

    def torque(self, now: Moment, memory: Memory) -> Float[Array, ""]:
        x = (now.angle - self.angle) / self.width
        return self.push * x * jnp.exp(-(x**2))


class CubicDamping(PhysicsTerm):
    """tau = -s phi'^3."""

    title: ClassVar[str] = "damping that grows with the cube of speed"
    reference: ClassVar[str] = REFERENCE
    explanation: ClassVar[str] = "Fast movement is damped far more than in proportion."
    isolate: ClassVar[str] = ISOLATE

    coefficient: Float[Any, ""] = parameter("s", "N m s^3/rad^3", 0.0, 0.5, "coefficient")

    def torque(self, now: Moment, memory: Memory) -> Float[Array, ""]:
        return -self.coefficient * now.angular_velocity**3


NOVEL = (AngleBump, MagneticDetent, AngleDamping, Kick, SnapWindow, CubicDamping)
