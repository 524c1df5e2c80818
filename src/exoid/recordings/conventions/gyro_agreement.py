"""Does a gyro say what the angle's own slope says? Its unit and its sign, by a regression."""

from dataclasses import dataclass

import numpy as np

from exoid.recordings.recording import Recording, Segment, known
from exoid.recordings.signal.condition import SMOOTHING
from exoid.recordings.signal.local_line import local_line

PAIRS = (("raw_angle", "raw_angular_velocity"), ("angle", "angular_velocity"))
FAST = 0.3  # of the greatest slope, from where on the noise of a slope does not matter
FEWEST = 8  # samples
ALIKE = 0.7  # correlation from which on gyro and slope are the same motion
DEGREE = float(np.degrees(1.0))
NEAR = 1.6  # factor within which a slope is that of a unit


@dataclass(frozen=True)
class Agreement:
    """The gyro over the angle's slope: 1 where all is well."""

    slope: float
    correlation: float
    column: str
    angle_column: str


def agreement(segment: Segment) -> Agreement | None:
    """The regression of the first pair there is; None where the two are no common motion."""
    channels = segment.channels()
    pair = next((pair for pair in PAIRS if channels.keys() >= {*pair}), None)
    if pair is None:
        return None
    angle, gyro = (channels[name] for name in pair)
    if np.sum(~np.isnan(angle)) < FEWEST:
        return None
    slope = local_line(segment.time, angle, SMOOTHING)[1]
    seen = ~np.isnan(gyro)
    seen &= np.abs(slope) > FAST * np.quantile(np.abs(slope), 0.99)
    if seen.sum() < FEWEST:
        return None
    mine, other = slope[seen], gyro[seen]
    both = np.sqrt(np.sum(mine**2) * np.sum(other**2))
    if not both > 0:
        return None
    columns = {entry.name: entry.metadata["column"] for entry in known(segment)}
    of_angle, of_gyro = (columns[name] for name in pair)
    return Agreement(
        float(mine @ other / np.sum(mine**2)), float(mine @ other / both), of_gyro, of_angle
    )


def wrong_unit(recording: Recording) -> str | None:
    """A gyro in deg/s, or an angle in degrees, where the column says rad."""
    for number, segment in enumerate(recording.segments):
        found = agreement(segment)
        if found is None or abs(found.correlation) < ALIKE:
            continue
        for factor, wrong in ((DEGREE, found.column), (1 / DEGREE, found.angle_column)):
            if factor / NEAR < abs(found.slope) < factor * NEAR:
                return (
                    f"segment {number}: {found.column} is {abs(found.slope):.3g} times the slope "
                    f"of {found.angle_column}. Is {wrong} in degrees? Then name the column "
                    f"{wrong.replace('_rad', '_deg')}; a log has its unit in the DBC."
                )
    return None


def wrong_sign(recording: Recording) -> str | None:
    """A gyro that turns the other way than the encoder."""
    for number, segment in enumerate(recording.segments):
        found = agreement(segment)
        if found is not None and found.correlation < -ALIKE and found.slope < -1 / NEAR:
            return (
                f"segment {number}: {found.column} is the slope of {found.angle_column} with the "
                "other sign. Extension is positive in both: say --flip gyro, or --flip angle "
                "where it is the angle that counts flexion."
            )
    return None
