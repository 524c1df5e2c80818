"""What a fit sees of a recording: samples to meet, their noise, and what drove each segment."""

from dataclasses import replace
from typing import Any

import equinox as eqx
from jaxtyping import Float, Int

from exoid.physics.motion.step import Drive
from exoid.physics.record import record


@record
class Clock:
    """The voluntary cycle of a segment, of frequency 0 where there is none, and its number."""

    period: Float[Any, "*segment"]  # s
    frequency: Float[Any, "*segment"]  # Hz
    onset: Float[Any, "*segment"]  # s
    number: Float[Any, "*segment"]


@record
class Observation:
    """One segment; a joint fit carries one more leading axis `segment`.

    Rows beyond the end of a segment continue its clock with weight 0, so that segments of
    different length share one shape.
    """

    time: Float[Any, "*segment time"]  # s
    angle: Float[Any, "*segment time"]  # rad
    angular_velocity: Float[Any, "*segment time"]  # rad/s
    angle_weight: Float[Any, "*segment time"]  # 1/rad: 1/unit, 0 where nothing was measured
    velocity_weight: Float[Any, "*segment time"]  # s/rad
    guide_angle: Float[Any, "*segment time"]  # rad, smoothed: what a start is tied to
    guide_velocity: Float[Any, "*segment time"]  # rad/s
    cycle: Drive  # Eq. 10 for unit amplitude at the stage times, 0 where not voluntary
    torque: Drive  # N m, the measured torque at the stage times, 0 where none was
    torque_reach: Float[Any, "*segment"]  # N m, the greatest of its recording; 0 where none was
    added_mass: Float[Any, "*segment"]  # kg
    added_mass_distance: Float[Any, "*segment"]  # m
    added_mass_moves: Float[Any, "*segment"]  # 1 where its distance follows the mounting, else 0
    added_mass_extent: Float[Any, "*segment"]  # m^2, its squared radius of gyration
    apart: Float[Any, "*segment"]  # from -1/2, the lightest of its recording's masses, to 1/2
    heavier: Float[Any, "*segment"]  # beyond the least mass of a fit, over the most of a recording
    damped: Float[Any, "*segment"]  # times the leg's damping, by what a fit has found beside a mass
    stiffened: Float[Any, "*segment"]  # times its stiffness, by the same
    thigh_angle: Float[Any, "*segment"]  # rad, the knee above the hip
    owner: Int[Any, "*segment"]  # which recording's mounting it has
    clock: Clock
    parts: int = eqx.field(static=True, default=1)  # of a step, where it is long for the motion

    def weighed(self, share: Any) -> "Observation":
        """The same with this share of every weight: 0 of a sample that is not to count."""
        angle, velocity = self.angle_weight * share, self.velocity_weight * share
        return replace(self, angle_weight=angle, velocity_weight=velocity)
