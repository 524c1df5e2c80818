"""What a recording owns beside the leg."""

from typing import Any

from jaxtyping import Float

from exoid.physics.record import record


@record
class Mounting:
    """What a recording owns: by how much sensors, seat and added mass differ from what is declared,
    and the leg that bears the mass from the one without.

    A leaf without entries is no unknown of this fit: everything is as declared.
    """

    log_distance: Float[Any, "..."]  # log(distance of the added mass over the declared one)
    log_added: Float[Any, "..."]  # log(added mass over the declared one)
    extent: Float[Any, "..."]  # m^2, its squared radius of gyration less the declared one
    zero: Float[Any, "..."]  # rad, what the encoder shows with the knee extended
    tilt: Float[Any, "..."]  # rad, of the thigh beyond the declared angle
    gyro_scale: Float[Any, "..."]  # relative, less 1
    gyro_bias: Float[Any, "..."]  # rad/s
    clock: Float[Any, "..."]  # relative: true seconds in a recorded one, less 1
    torque_zero: Float[Any, "..."]  # what a torque sensor shows of none, over its greatest reading
    torque_gain: Float[Any, "..."]  # relative, less 1, of the same sensor
    damping_under_load: Float[Any, "..."]  # the leg's d beside its heaviest added mass over that
    stiffness_under_load: Float[Any, "..."]  # with the least mass of a fit, less 1; and its c
    distance_apart: Float[Any, "..."]  # log_distance of its heaviest added mass less its lightest's
    extent_apart: Float[Any, "..."]  # m^2, and of the extents


def acting(shown: Any, zero: Any, gain: Any) -> Any:
    """The torque behind what its sensor shows, by the sensor's zero, in the same unit, and gain."""
    return (shown - zero) / (1 + gain)
