"""How much of a motion a misfit looks at."""

from dataclasses import field
from typing import Any

from jaxtyping import Float, Int

from exoid.physics.record import record


@record
class Stage:
    """How much of the motion a misfit looks at, and how freely the simulation moves.

    A start that is far from the leg begins tied to the measured motion by a critically damped
    spring, which makes the misfit nearly linear in the parameters, and ends free.
    """

    tether: Float[Any, ""]  # rad/s, natural frequency of the spring; 0 is free
    steps: Int[Any, ""]  # of the simulation, from the first sample on
    compact: bool = field(
        metadata={"static": True}, default=False
    )  # compiled sooner, and slower to run
