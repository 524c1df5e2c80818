"""Does a gyro say what the angle's own slope says? Its unit and its sign, by a regression."""

from dataclasses import dataclass

import numpy as np

from exoid.recordings.declared.entry import known
from exoid.recordings.measured.samples import Samples
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from exoid.recordings.signal.condition import SMOOTHING
from exoid.recordings.signal.local_line import local_line

PAIRS = (("raw_angle", "raw_angular_velocity"), ("angle", "angular_velocity"))
FAST = 0.3  # of the greatest slope, from where on the noise of a slope does not matter
FEWEST = 8  # samples
ALIKE = 0.7  # correlation from which on gyro and slope are the same motion
DEGREE = float(np.degrees(1.0))
NEAR = 1.6  # factor within which a slope is that of a unit
TURN = 2 * np.pi  # rad, which no knee moves: its angle is in degrees
MOVES = np.radians(10.0)  # rad, of a movement that no gyro misses
IN_RADIANS = (
    "The angle moves as a leg does: is the gyro in rad/s, and its column says deg/s? Then name the "
    "column {0}."
)


@dataclass(frozen=True)
class Agreement:
    """The gyro over the angle's slope: 1 where all is well."""

    slope: float
    correlation: float
    column: str
    angle_column: str
    travel: float  # rad, of the angle from end to end


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
    of_angle, of_gyro = (column_of(segment, name) for name in pair)
    slope, correlation = mine @ other / np.sum(mine**2), mine @ other / both
    travel = np.nanmax(angle) - np.nanmin(angle)
    return Agreement(float(slope), float(correlation), of_gyro, of_angle, float(travel))


def column_of(segment: Segment, channel: str) -> str:
    """What a table calls a channel."""
    return next(entry.metadata["column"] for entry in known(segment) if entry.name == channel)


def wrong_unit(recording: Recording) -> str | None:
    """A gyro in deg/s, or an angle in degrees, where the column says rad; or a gyro in rad/s that
    was called deg/s.
    """
    for number, segment in enumerate(recording.segments):
        found = agreement(segment)
        if found is None or abs(found.correlation) < ALIKE:
            continue
        gyro, angle = found.column, found.angle_column
        said = f"segment {number}: {gyro} is {abs(found.slope):.3g} times the slope of {angle}."
        if is_near(found.slope, DEGREE):
            return f"{said} {in_degrees(gyro)}"
        if is_near(found.slope, 1 / DEGREE):
            return f"{said} {in_degrees(angle) if found.travel > TURN else IN_RADIANS.format(gyro)}"
    return None


def is_near(slope: float, factor: float) -> bool:
    return factor / NEAR < abs(slope) < factor * NEAR


def in_degrees(column: str) -> str:
    return (
        f"Is {column} in degrees? Then name the column {column.replace('_rad', '_deg')}; a log has "
        "its unit in the DBC."
    )


def dead_gyro(recording: Recording) -> str | None:
    """A gyro with one value all along, while the angle moves."""
    for number, segment in enumerate(recording.segments):
        channels = segment.channels()
        for angle, gyro in PAIRS:
            if not channels.keys() >= {angle, gyro}:
                continue
            moved, shown = (values(channels[name]) for name in (angle, gyro))
            enough = np.count_nonzero(~np.isnan(channels[gyro])) >= FEWEST
            if enough and shown.size == 1 and moved.size and moved[-1] - moved[0] > MOVES:
                return (
                    f"segment {number}: the angle moves, and {column_of(segment, gyro)} stays at "
                    f"{shown[0] + 0.0:.3g} all along. Is the gyro unplugged? Leave its column out, "
                    "or record it again."
                )
    return None


def values(samples: Samples) -> Samples:
    """All that were measured, each once, the least first."""
    return np.unique(samples[~np.isnan(samples)])


def wrong_sign(recording: Recording, flip: str | None) -> str | None:
    """A gyro that turns the other way than the encoder, once what was told to `flip` is."""
    for number, segment in enumerate(recording.segments):
        found = agreement(segment)
        if found is not None and found.correlation < -ALIKE and found.slope < -1 / NEAR:
            return (
                f"segment {number}: {found.column} is the slope of {found.angle_column} with the "
                f"other sign{of_signs(flip)}"
            )
    return None


def of_signs(flip: str | None) -> str:
    """What to say in place of `flip` where angle and gyro then have unlike signs."""
    if flip in ("angle", "gyro"):
        return (
            f', once flip="{flip}" is done: the file has one sign for both. Say flip="all" where '
            "it counts flexion as positive, and nothing where it does not."
        )
    return (
        '. Extension is positive in both: say flip="gyro", or flip="angle" where it is the angle '
        "that counts flexion."
    )
