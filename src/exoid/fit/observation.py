"""What a fit sees of a recording: samples to meet, their weight, and what drove each segment."""

import equinox as eqx
from jaxtyping import Array, Bool, Float

from exoid.physics.simulate import Drive


class Observation(eqx.Module):
    """One segment; a joint fit carries one more leading axis `segment`.

    Rows beyond the end of a segment continue its clock with weight 0, so that segments of
    different length share one shape.
    """

    time: Float[Array, "*segment time"]  # s
    angle: Float[Array, "*segment time"]  # rad, after the chain of conditioning
    angular_velocity: Float[Array, "*segment time"]  # rad/s
    angle_weight: Float[Array, "*segment time"]  # 1/rad: 1/noise, 0 where nothing was measured
    velocity_weight: Float[Array, "*segment time"]  # s/rad
    guide_angle: Float[Array, "*segment time"]  # rad, smoothed: what a start is tied to
    guide_velocity: Float[Array, "*segment time"]  # rad/s
    cycle: Drive  # Eq. 10 for unit amplitude at the stage times, 0 where not voluntary
    torque: Drive  # N m, the measured torque at the stage times, 0 where none was
    voluntary: Bool[Array, "*segment"]  # does the amplitude of Eq. 10 act here
    added_mass: Float[Array, "*segment"]  # kg
    added_mass_distance: Float[Array, "*segment"]  # m
