"""All that motion can tell of a leg: Eq. 9 divided by J."""

from dataclasses import field
from typing import Any

import equinox as eqx
import numpy as np
from jaxtyping import Float


def horizontal() -> np.ndarray:
    """The angle [rad] of the thigh of a person who sits as the paper has it."""
    return np.zeros(())


class Ratios(eqx.Module):
    """Eq. 9 divided by J: all that motion can tell of a leg.

    phi'' = tau_h / J - gravity cos(phi + thigh_angle) - stiffness phi - damping phi'
    """

    gravity: Float[Any, "*batch"]  # m l g / J, 1/s^2
    stiffness: Float[Any, "*batch"]  # c / J, 1/s^2
    damping: Float[Any, "*batch"]  # d / J, 1/s
    thigh_angle: Float[Any, "*batch"] = field(
        default_factory=horizontal
    )  # rad, the knee above the hip
