"""The measured motion that a start is tied to on its way to the data."""

from exoid.fitting.data.movement import Movement, angle_of_leg
from exoid.fitting.data.pace import unhurried
from exoid.recordings.measured.samples import Samples
from exoid.recordings.signal.local_line import interpolated, local_line

GUIDE_WIDTH = 0.06  # s, over which angle and velocity are smoothed
OF_SLOPE = 3 / 5  # a line loses width^2 pace^2 / 40 of a swing's slope, / 24 of its value


def guide_of(each: Movement) -> tuple[Samples, Samples]:
    """Its angle [rad] and the slope of that [rad/s], whatever the gyro says."""
    time, width = each.segment.time, unhurried(each, GUIDE_WIDTH)
    angle = twiced(time, interpolated(time, angle_of_leg(each)), width)[0]
    return angle, twiced(time, angle, width)[1]


def twiced(time: Samples, samples: Samples, width: float) -> tuple[Samples, Samples]:
    """Value and slope of the local lines and of those of what they leave (Tukey, Exploratory Data
    Analysis, 1977: twicing).

    A line cuts the peaks of a swing by up to 1 %. What is tied to them is taken for a leg that is
    3 % slower and moved by a thrust, and a known mass on it for none. What is lost then is lost
    squared.
    """
    smooth, slope = local_line(time, samples, width)
    more, steeper = local_line(time, samples - smooth, width)
    return smooth + more, slope + OF_SLOPE * steeper
