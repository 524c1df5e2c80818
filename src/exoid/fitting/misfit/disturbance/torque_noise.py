"""What the white noise of a measured torque leaves in a residual."""

from dataclasses import dataclass
from math import sqrt

import numpy as np

from exoid.fitting.data.movement import Movement
from exoid.fitting.misfit.missed import Missed
from exoid.recordings.measured.samples import usual_step
from exoid.recordings.signal.noise import noise_of

WHOLE = 16 / (3 * sqrt(5))  # correlation times, of the integral over a Matern 5/2 covariance
LIKE = 4.0  # times the power of the noise, up to which it explains what was found
FAINT = 0.25  # of how much a torque varies, that is its sensor's noise at most, not a noisy drive


@dataclass(frozen=True)
class TorqueNoise:
    """The white noise of the torque sensor of a recording."""

    level: float  # N m, standard deviation of a sample
    step: float  # s, from sample to sample

    def explains(self, found: Missed, inertia: float | None) -> bool:
        """Has the torque that a model misses no more power at low frequencies, where a leg or a
        motor moves, than this noise? `inertia` [kg m^2] is that of the fit.
        """
        if found.cause != "torque" or inertia is None:
            return False
        power = (found.deviation * inertia) ** 2 * WHOLE * found.correlation_time
        return power < LIKE * self.level**2 * self.step


def torque_noise(movements: list[Movement]) -> TorqueNoise | None:
    """That of all measured torques together; None where there is none, or where they are driven by
    noise.
    """
    each = [
        (one.segment.time, one.segment.applied_torque)
        for one in movements
        if one.kind == "measured" and one.segment.applied_torque is not None
    ]
    if not each:
        return None
    times, torques = (list(one) for one in zip(*each, strict=True))
    level = noise_of(times, torques, None).level
    if level > FAINT * np.nanstd(np.concatenate(torques)):
        return None
    return TorqueNoise(level, float(np.median([usual_step(time) for time in times])))
