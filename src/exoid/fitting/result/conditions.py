"""How the simulation of a segment began, and what acted on the leg beside Eq. 9's own torques."""

from dataclasses import dataclass
from typing import Annotated

import numpy as np
from jaxtyping import Float


@dataclass(frozen=True, eq=False)
class Conditions:
    """What it takes, beside the model, to simulate a segment again; by the recording's own clock.

    >>> begun = exoid.fit("drops.csv").segments[0].conditions
    >>> round(float(np.degrees(begun.angle)))  # deg, where the leg was let go
    -12
    """

    angle: Annotated[float, "rad"]  # at the first fitted sample
    angular_velocity: Annotated[float, "rad/s"]
    thigh_angle: Annotated[float, "rad"]  # the tilt that the fit found included
    clock: Annotated[float, "1"]  # true seconds in a recorded one, less 1
    number: int  # of the segment, from 0
    added_mass: Annotated[float, "kg"]
    added_distance: Annotated[float, "m"]  # from the knee
    added_inertia: Annotated[float, "kg m^2"]  # about the knee
    zero: Annotated[float, "rad"]  # what the encoder shows with the knee extended
    gyro_scale: Annotated[float, "1"]  # relative, less 1
    gyro_bias: Annotated[float, "rad/s"]
    amplitude: Annotated[float, "N m"]  # of the voluntary torque, 0 where there is none
    period: Annotated[float, "s"]
    frequency: Annotated[float, "Hz"]
    onset: Annotated[float, "s"]
    torque: Annotated[Float[np.ndarray, " sample"] | None, "N m"] = None  # that was measured
    finer: int = 1  # parts of a step, in which what is quick or sticks is simulated
