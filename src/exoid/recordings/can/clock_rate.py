"""How fast the node's clock runs against the recording computer's, and how sure that is.

A node without a crystal is percents off where no USB host paces it. Its gyro is not: the chip
tells rad/s whatever the node's clock does. So what is told of the node's seconds is wrong, and a
host that heard for long enough says by how much.
"""

from dataclasses import dataclass
from math import hypot

import numpy as np
from jaxtyping import Float

SHORTEST_FIT = 2.0  # s of log from which a clock can be compared with another
WORST_HOST = 0.1  # s; a host whose times scatter more was set while it recorded
MICROSECOND = 1e-6
BLOCKS = 10  # of a log, each long enough to take the noise out of what is left of its line
FASTEST, SLOWEST = 1.1, 0.9  # host over node; beyond, the log was played back, not heard
HOST_CLOCK = 1e-4  # of the host itself: a quartz, cheap and warm
CRYSTALLESS = 0.01  # of the node: SAMD21 data sheet, DFLL48M in open loop, 47 to 49 MHz
SURE = 2e-3  # error of a rate that is applied; a tenth of what a node may be off
SEEN = 2.0  # errors; less is left alone

Seconds = Float[np.ndarray, " frame"]


@dataclass(frozen=True)
class ClockRate:
    """Seconds of the node in one of the host, less 1: positive where the node's clock is fast."""

    excess: float
    error: float  # one standard deviation
    jitter: float  # s, median distance of a frame's host time from its sample

    @property
    def applied(self) -> bool:
        """Is it known well enough, and more than its own error, so that times are corrected?"""
        return self.error <= SURE and abs(self.excess) > SEEN * self.error

    @property
    def uncertainty(self) -> float:
        """Of the times as they are given, corrected or not; one standard deviation, of 1.

        Where they are not, what the host tells and what is usual of a node count by their errors.
        """
        if self.applied:
            return self.error
        weight = CRYSTALLESS**2 / (CRYSTALLESS**2 + self.error**2)
        return hypot(weight * self.excess, weight**0.5 * self.error)

    @property
    def factor(self) -> float:
        """By what the node's seconds are multiplied."""
        return 1 / (1 + self.excess) if self.applied else 1.0


def clock_rate(device: Seconds, host: Seconds) -> ClockRate | None:
    """The rate by which frames of a known device time reached the host; None where none can tell.

    What is left of the line, in the middle of each tenth of the log, is noise, a host that grew
    busier, or one whose clock was set. Were it all a step in the middle, as tall as twice the tenth
    that is farthest off, the slope would be wrong by three times that over the length of the log.
    That is the error; scatter alone makes one about four times smaller.
    """
    if device.size < BLOCKS or np.ptp(device) < SHORTEST_FIT:
        return None
    host = host - host[0]
    slope, level, scatter = fitted_line(device, host)
    if scatter >= WORST_HOST or not SLOWEST < slope < FASTEST:
        return None
    left = np.array_split(host - level - slope * device, BLOCKS)
    middles = np.array([np.median(each) for each in left])
    farthest = float(np.abs(middles - np.median(middles)).max())
    error = hypot(3 * farthest / float(np.ptp(device)), HOST_CLOCK)
    return ClockRate(1 / slope - 1, error, scatter)


def clock_lines(rate: ClockRate | None) -> list[str]:
    """What is known of the node's clock, what was done, and what it does to the numbers."""
    if rate is None:
        return [
            "how fast the node's clock runs cannot be told: too short a log, or no steady host "
            f"time. {consequences(CRYSTALLESS)}"
        ]
    told = (
        f"the node's clock runs {percent(rate.excess)} against the recording computer's "
        f"(± {100 * rate.error:.2f} %; its times jitter by {rate.jitter * 1e3:.2f} ms)"
    )
    if rate.applied:
        return [
            f"{told}: times are corrected by it. The node's filter knew nothing of it: its "
            f"acceleration is {percent(1 / (1 + rate.excess) - 1)} off as it was sent, its rate "
            "is the gyro's"
        ]
    if rate.error <= SURE:
        return [f"{told}: less than {SEEN:g} such errors, so times are left as the node tells them"]
    return [f"{told}: too unsure to correct the times by. {consequences(rate.uncertainty)}"]


def consequences(share: float) -> str:
    return (
        f"Times may be {100 * share:.1f} % off (one standard deviation): then a rate told from "
        f"angles and d/J are {100 * share:.1f} % off, an acceleration told from them, m l g/J and "
        f"c/J {200 * share:.1f} %; the gyro's rate is right"
    )


def percent(share: float) -> str:
    return f"{100 * share:+.2f} %"


def fitted_line(x: Seconds, y: Seconds) -> tuple[float, float, float]:
    """Slope, value at x = 0 and scatter of y over x: least squares, outliers left out twice."""
    keep = np.ones(x.size, dtype=bool)
    for _ in range(2):
        distance = np.abs(y - np.polynomial.polynomial.polyval(x, line(x[keep], y[keep])))
        # Four times the middle distance; no log resolves time finer than a microsecond.
        keep = distance <= 4 * np.median(distance) + MICROSECOND
    level, slope = line(x[keep], y[keep])
    return slope, level, float(np.median(np.abs(y - level - slope * x)))


def line(x: Seconds, y: Seconds) -> tuple[float, float]:
    """Level and slope by least squares."""
    offset = x - x.mean()
    slope = float(offset @ (y - y.mean()) / (offset @ offset))
    return float(y.mean() - slope * x.mean()), slope
