"""A recording as the samples of a stream."""

import numpy as np

from exoid.online.model.sample import Sample
from exoid.recordings.recording import Recording, Segment

PAUSE = 1.0  # s between segments, each of which has a clock of its own


def samples_of(recording: Recording) -> Sample:
    """What `replay` takes: the segments one after the other, 1 s apart, by the best angle, the
    gyro and the torque they have, and with the added mass of each:
    `online.replay(belief, online.samples_of(recording))`.

    Two masses in one stream are exact unless the model says how they were weighed (see `Sample`).
    """
    columns, begin = [], 0.0
    for number, segment in enumerate(recording.segments):
        mass = recording.added_mass(number) or 0.0
        distance = recording.added_mass_distance(number)
        if mass and distance is None:
            raise ValueError(
                f"nobody says where the mass of {mass:g} kg of segment {number} sits, which the "
                "online estimator needs to know: give added_mass_distance_m."
            )
        rows = columns_of(segment, begin)
        columns.append([*rows, *(np.full_like(rows[0], each) for each in (mass, distance or 0.0))])
        begin = float(rows[0][-1]) + PAUSE
    return Sample(*map(np.concatenate, zip(*columns, strict=True)))


def columns_of(segment: Segment, begin: float) -> list[np.ndarray]:
    """Time, angle, rate and torque; NaN where there is no gyro."""
    missing = np.full(segment.time.shape, np.nan)
    rates = (segment.raw_angular_velocity, segment.angular_velocity, missing)
    rate = next(each for each in rates if each is not None)
    torque = np.zeros_like(missing) if segment.applied_torque is None else segment.applied_torque
    return [segment.time - segment.time[0] + begin, segment.best_angle, rate, torque]
