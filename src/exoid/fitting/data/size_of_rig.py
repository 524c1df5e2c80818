"""How large a rig's motion and torque are beside a leg's, by its recording."""

from collections.abc import Sequence

import numpy as np

from exoid.fitting.data.movement import Movement
from exoid.fitting.data.pace import LEG, pace
from exoid.physics.scale import Scale

ANGLE, TORQUE = 0.4, 5.0  # rad, N m: a leg's, root mean square
ALIKE = 5.0  # a rig within this factor of a leg is as a leg


def scale_of(movements: Sequence[Movement]) -> Scale:
    """What the movements of a rig say of its size; without a measured torque nothing of that."""
    angles = np.concatenate([each.angle - np.nanmean(each.angle) for each in movements])
    rates = [rate for each in movements if (rate := pace(each)) > 0]
    torques = [each.segment.applied_torque for each in movements if each.kind == "measured"]
    driven = np.concatenate([each for each in torques if each is not None] or [[TORQUE]])
    return Scale(
        torque=beside(float(np.sqrt(np.nanmean(driven**2))), TORQUE),
        angle=beside(float(np.sqrt(np.nanmean(angles**2))), ANGLE),
        time=beside(LEG, float(np.median(rates)) if rates else LEG),
    )


def beside(size: float, leg: float) -> float:
    """Their ratio; 1 where it is about that."""
    ratio = size / leg
    return 1.0 if 1 / ALIKE < ratio < ALIKE else ratio
