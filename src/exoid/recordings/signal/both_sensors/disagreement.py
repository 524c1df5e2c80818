"""By how much gyro and encoder of a recording disagree in scale, surely, and without a model.

As angles: the gyro's rate, integrated, is smoothed just as the encoder's angle is, or the smoothing
alone would make a tenth of a percent between a slope and a rate.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from exoid.recordings.measured.samples import Samples
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from exoid.recordings.remembered import remembered
from exoid.recordings.signal.both_sensors.sensor_scales import DISAGREE
from exoid.recordings.signal.condition import SMOOTHING
from exoid.recordings.signal.local_line import interpolated, local_line

FAST = 0.3  # of the greatest rate, from where on noise does not matter
FEWEST = 20  # samples of a segment that tell a scale
BLOCK = 0.25  # s, half a swing, of errors that belong together
BLOCKS = 4  # at least, whose scatter tells the error


@dataclass(frozen=True)
class ScaleApart:
    """The gyro's rate over the slope of the angle, less 1, with its standard error."""

    value: float
    error: float

    @property
    def sure(self) -> bool:
        return abs(self.value) > DISAGREE * self.error


@dataclass(frozen=True, eq=False)
class BothSlopes:
    """Of encoder and gyro where the leg is fast, each less its mean, over the same windows."""

    slope: Samples  # rad/s, of the encoder's angle
    rate: Samples  # rad/s
    change: Samples  # rad/s^2, by which a sensor is off that is late
    block: NDArray[np.int_]  # of samples that belong together, by number


@remembered  # for every of its segments
def disagreement(recording: Recording) -> ScaleApart | None:
    """Of all segments together, whose gyro and clock are the same; None where nothing tells it.

    slope = rate / (1 + scale) + late * change, by least squares: the gyro's noise is small, and the
    encoder's would shrink what it is divided by.
    """
    each = [found for one in recording.segments if (found := slopes_of(one)) is not None]
    if not each:
        return None
    slope, rate, change = (
        np.concatenate([getattr(one, name) for one in each]) for name in ("slope", "rate", "change")
    )
    sizes = np.cumsum([0, *(one.block[-1] + 1 for one in each)]).astype(int)
    block = np.concatenate([at + one.block for at, one in zip(sizes, each, strict=False)])
    if sizes[-1] < BLOCKS:
        return None
    columns = np.stack([rate, change], axis=1)
    (gain, late), *_ = np.linalg.lstsq(columns, slope, rcond=None)
    alone = rate - change * float(rate @ change) / float(change @ change)
    left = np.bincount(block, weights=alone * (slope - columns @ (gain, late)))
    scatter = float(np.linalg.norm(left)) / float(alone @ rate)
    lowered = late**2 * float(change @ change) / float(rate @ rate) / 2  # as by what makes it late
    return ScaleApart(float(1 / gain - 1), float(np.hypot(scatter, lowered)))


def slopes_of(segment: Segment) -> BothSlopes | None:
    """None where a sensor is missing, or was not at work for long enough."""
    time, angle, rate = segment.time, segment.raw_angle, segment.raw_angular_velocity
    if angle is None or rate is None:
        return None
    seen = ~np.isnan(angle) & ~np.isnan(rate)
    if seen.sum() < FEWEST:
        return None
    turned = integrated(time, interpolated(time, rate))
    slope, alike = (local_line(time, each, SMOOTHING)[1] for each in (angle, turned))
    seen &= np.abs(alike) > FAST * np.quantile(np.abs(alike), 0.99)
    if seen.sum() < FEWEST:
        return None
    block = np.unique((time[seen] - time[0]) // BLOCK, return_inverse=True)[1]
    change = local_line(time, rate, SMOOTHING)[1]
    slope, alike, change = (each[seen] - each[seen].mean() for each in (slope, alike, change))
    return BothSlopes(slope, alike, change, block)


def integrated(time: Samples, rate: Samples) -> Samples:
    """The angle [rad] by a rate [rad/s], to the fourth order of a step."""
    step, change = np.diff(time), local_line(time, rate, SMOOTHING)[1]
    turned = step * (rate[1:] + rate[:-1]) / 2 - step**2 * np.diff(change) / 12
    return np.concatenate([[0.0], np.cumsum(turned)])
