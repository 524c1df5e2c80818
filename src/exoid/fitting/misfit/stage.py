"""How much of a motion a misfit looks at."""

from typing import Any

import equinox as eqx
from jaxtyping import Float, Int


class Stage(eqx.Module):
    """How much of the motion a misfit looks at, and how freely the simulation moves.

    A start that is far from the leg begins tied to the measured motion by a critically damped
    spring, which makes the misfit nearly linear in the parameters, and ends free.
    """

    tether: Float[Any, ""]  # rad/s, natural frequency of the spring; 0 is free
    steps: Int[Any, ""]  # of the simulation, from the first sample on
    compact: bool = eqx.field(static=True, default=False)  # compiled sooner, and slower to run
