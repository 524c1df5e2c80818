"""One sample of the node, and what was declared of that instant."""

from dataclasses import dataclass
from typing import Any

import jax
from jaxtyping import Float


@jax.tree_util.register_dataclass
@dataclass(frozen=True)  # an equinox module takes as long to make as to absorb
class Sample:
    """What encoder and gyro showed, NaN where one of them was missing; what pushed and weighed.

    A torque is exact, and so is a mass unless `Unknowns(weighed=Weighed())` says how well it is
    known: one that is 1 % heavier makes J 1 % larger, one that is 5 mm off its place 6 %.
    `exoid live` and `exoid.fit` always allow for that.

    >>> float(online.Sample(0.01, -0.35, 0.002).torque)  # N m
    0.0
    """

    time: Float[Any, "*time"] | float  # s, on the node's clock
    angle: Float[Any, "*time"] | float  # rad
    angular_velocity: Float[Any, "*time"] | float  # rad/s
    torque: Float[Any, "*time"] | float = 0.0  # N m, known, extension positive
    added_mass: Float[Any, "*time"] | float = 0.0  # kg, fixed to the shank
    added_mass_distance: Float[Any, "*time"] | float = 0.0  # m, from the knee
