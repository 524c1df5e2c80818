"""What every recording owned of the exoskeleton's seat on the leg, with errors."""

import numpy as np

from exoid.fit.coordinates import TYPICAL, flattened, unflattened
from exoid.fit.movement import places, remounts
from exoid.fit.multistart import Ended
from exoid.fit.problem import Problem, take
from exoid.fit.result import Estimate, MountingFit
from exoid.fit.uncertainty import Information

MOUNTING = {  # name: symbol, title, unit
    "added_mass_distance": ("r", "distance of the added mass from the knee", "m"),
    "zero": ("zero", "encoder zero against the first recording", "rad"),
    "gyro_scale": ("scale", "gyro scale against the first recording, less 1", "-"),
    "gyro_bias": ("bias", "gyro bias against the first recording", "rad/s"),
}


def estimate_mountings(
    problem: Problem, ended: Ended, information: Information
) -> list[MountingFit]:
    """What every recording owned, of what was to be estimated."""
    point = take(ended.best.coordinates, 0)
    number = unflattened(np.arange(flattened(point).size), point).mounting
    distances, others = places(problem.movements), remounts(problem.movements)

    def estimate(name: str, field: str, entry: int) -> Estimate:
        at = int(getattr(number, field)[entry])
        value = float(getattr(point.mounting, field)[entry])
        slope = float(getattr(TYPICAL.mounting, field))
        if field == "log_distance":
            value = float(np.exp(value))
            slope *= value
        gradient = slope * np.eye(flattened(point).size)[at]
        shares = information.shares(gradient)
        error = None if shares is None else information.standard_error(gradient)
        return Estimate(*MOUNTING[name], value=value, standard_error=error, shares=shares)

    def mounting(recording: int) -> MountingFit:
        name = next(each.source for each in problem.movements if each.recording == recording)
        placed, moved = recording in distances, recording in others
        return MountingFit(
            name,
            estimate("added_mass_distance", "log_distance", distances.index(recording))
            if placed
            else None,
            *(
                estimate(each, each, others.index(recording)) if moved else None
                for each in ("zero", "gyro_scale", "gyro_bias")
            ),
        )

    return [mounting(recording) for recording in sorted({*distances, *others})]
