"""The leg at one instant, as a term of the missing physics sees it."""

from dataclasses import field
from typing import Any

import equinox as eqx
import jax.numpy as jnp
import numpy as np
from jaxtyping import Array, Float

from exoid.physics.ratios import Ratios
from exoid.physics.waves import cycle_shape

CARRIED = 2.5  # of a rate times the step: Runge-Kutta of order four carries 2.8


class Cycle(eqx.Module):
    """The voluntary cycle of Eq. 10; of amplitude 0 where nothing is voluntary."""

    amplitude: Float[Any, "*batch"]  # N m
    period: Float[Any, "*batch"]  # s
    frequency: Float[Any, "*batch"]  # Hz
    onset: Float[Any, "*batch"]  # s, on the segment's clock

    def torque(self, time: Float[Any, "*batch"]) -> Float[Array, "*batch"]:
        """Eq. 10 [N m]."""
        return self.amplitude * cycle_shape(time - self.onset, self.period, self.frequency)

    def phase(self, time: Float[Any, "*batch"]) -> Float[Array, "*batch"]:
        """2 pi f t since the onset [rad]."""
        return 2 * jnp.pi * self.frequency * (time - self.onset)

    def side(self, time: Float[Any, "*batch"]) -> Float[Array, "*batch"]:
        """The sign before the sine of Eq. 10: -1 up to half the period, +1 after it; 0 before."""
        clock = time - self.onset
        return jnp.where(clock < 0, 0.0, jnp.where(clock <= self.period / 2, -1.0, 1.0))


def nothing() -> np.ndarray:
    """No spring ties the motion to another; contacts are where they are."""
    return np.zeros(())


class SegmentConstants(eqx.Module):
    """What stays the same throughout a segment: leg, cycle, and the segment's number.

    A critically damped spring of natural frequency `tether` may tie the leg to a measured motion;
    the ratios hold its stiffness and damping. Within a step that comes to a contact, `slack` is
    what still counts as touching: less than nothing before, more than nothing after. What changes
    more quickly than a `step` can carry is slowed down to it.
    """

    ratios: Ratios
    inertia: Float[Any, "*batch"]  # kg m^2, of all that moves
    cycle: Cycle
    number: Float[Any, "*batch"]  # of the segment, from 0
    tether: Float[Any, "*batch"] = field(default_factory=nothing)  # rad/s, in the ratios
    slack: Float[Any, "*batch"] = field(default_factory=nothing)  # rad
    step: Float[Any, "*batch"] = field(default_factory=nothing)  # s, of the simulation

    def with_slack(self, slack: Any) -> "SegmentConstants":
        """The same with gaps below `slack` [rad] closed."""
        return eqx.tree_at(lambda place: place.slack, self, slack)

    def with_step(self, step: Any) -> "SegmentConstants":
        """The same in steps [s] of this length."""
        return eqx.tree_at(lambda place: place.step, self, step)


class Moment(eqx.Module):
    """An instant of a motion.

    >>> class Mud(exoid.PhysicsTerm):
    ...     title = reference = explanation = isolate = "mud"
    ...     level: jax.Array = exoid.parameter("D", "N m s/rad", 0.0, 5.0)
    ...     def torque(self, now: exoid.Moment, memory):
    ...         return -self.level * now.angular_velocity
    """

    time: Float[Any, "*batch"]  # s, on the segment's clock
    angle: Float[Any, "*batch"]  # rad
    angular_velocity: Float[Any, "*batch"]  # rad/s
    angular_acceleration: Float[Any, "*batch"]  # rad/s^2, by Eq. 9 and tether without any term
    place: SegmentConstants

    @property
    def inertia(self):
        """J [kg m^2]."""
        return self.place.inertia

    @property
    def gravity(self):
        """m l g [N m]."""
        return self.place.ratios.gravity * self.place.inertia

    @property
    def stiffness(self):
        """c [N m/rad]."""
        return (self.place.ratios.stiffness - self.place.tether**2) * self.place.inertia

    @property
    def damping(self):
        """d [N m s/rad]."""
        return (self.place.ratios.damping - 2 * self.place.tether) * self.place.inertia

    @property
    def tilted(self):
        """The angle against the horizontal [rad]."""
        return self.angle + self.place.ratios.thigh_angle
