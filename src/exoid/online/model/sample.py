"""One sample of the node, and what was declared of that instant."""

from typing import Any

import equinox as eqx
from jaxtyping import Float


class Sample(eqx.Module):
    """What encoder and gyro showed, NaN where one of them was missing; what pushed and weighed.

    >>> float(online.Sample(0.01, -0.35, 0.002).torque)  # N m
    0.0
    """

    time: Float[Any, "*time"] | float  # s, on the node's clock
    angle: Float[Any, "*time"] | float  # rad
    angular_velocity: Float[Any, "*time"] | float  # rad/s
    torque: Float[Any, "*time"] | float = 0.0  # N m, known, extension positive
    added_mass: Float[Any, "*time"] | float = 0.0  # kg, fixed to the shank
    added_mass_distance: Float[Any, "*time"] | float = 0.0  # m, from the knee
