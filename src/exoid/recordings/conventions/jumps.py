"""Jumps of an angle that no leg makes: a frame that slips, or samples that are lost.

Between two samples an angle turns by the integral of its rate. A sensor may err in scale, in bias
or by a delay; none of these is in one step and not in those beside it. What strikes a leg is in its
rate as well. Without a gyro a step is compared with those beside it alone.
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from exoid.recordings.measured.samples import Samples, robust_deviation
from exoid.recordings.measured.segment import Segment
from exoid.recordings.signal.local_line import interpolated

NEAR = 10  # steps on either side, that show what is usual there
SURE = 8.0  # standard deviations of a step ...
ALONE = 4.0  # ... and times the greatest beside it
LEAST = np.radians(0.5)
UNSEEN = np.radians(2.0)  # the same without a gyro: what strikes a rig turns it by less in a step
LONG = 2.5  # times the usual step, in which nobody knows how the leg moved
STAYS = 0.7  # of a jump, by which the angle is off on its other side
BESIDE = 5  # samples on either side, by which that is seen
AGAIN = "Cut the recording there, or record it again"


@dataclass(frozen=True)
class Jump:
    """Between a sample and the one before it."""

    time: float  # s
    size: float  # rad, beyond what the gyro turned

    @property
    def words(self) -> str:
        return f"jumps by {np.degrees(self.size):.2g} deg at {self.time:.2f} s"


def jumps(time: Samples, angle: Samples, rate: Samples | None, noise: float) -> list[Jump]:
    """All of them; `noise` is that of the angle [rad]."""
    known = ~np.isnan(angle)  # beside a jump one sample may have been taken for a wild one
    if known.sum() < 2 * NEAR + 2:
        return []
    usual, least = float(np.median(np.diff(time))), LEAST
    if rate is None or np.isnan(rate).all():
        rate, least = np.zeros(time.size), UNSEEN
    rate, time, angle = interpolated(time, rate)[known], time[known], angle[known]
    step = np.diff(time)
    apart = np.diff(angle) / step - (rate[1:] + rate[:-1]) / 2
    beyond = step * (apart - np.median(windows(apart), axis=1))
    scale = robust_deviation(beyond, 2**0.5 * noise)
    beside = np.abs(windows(beyond)).max(axis=1)
    struck = step * np.abs(np.diff(rate))
    size = np.abs(beyond)
    clear = (size > least) & (size > SURE * scale + struck) & (size > ALONE * beside)
    gone = np.concatenate([[0.0], np.cumsum(beyond)])
    return [
        Jump(float(time[at + 1]), float(beyond[at]))
        for at in np.flatnonzero(clear & (step < LONG * usual))
        if stays(gone, int(at), float(beyond[at]))
    ]


def jumps_of(segment: Segment, noise: float) -> list[Jump]:
    """The same of what the sensors gave, by the clock of the recording; a filter's channels do not
    jump.
    """
    angle, rate = segment.raw_angle, segment.raw_angular_velocity
    clock = segment.begins + segment.time
    return [] if angle is None else jumps(clock, angle, rate, noise)


def told_jumps(found: list[Jump]) -> str:
    """What jumps, and what makes it jump; nothing where nothing does."""
    if not found:
        return ""
    most = max(found, key=lambda one: abs(one.size))
    more = f", and {len(found) - 1} times more" if len(found) > 1 else ""
    return (
        f"the angle {most.words}{more}, as no leg moves: a frame slipped, an encoder stood still, "
        "or samples are lost"
    )


def jumping(segments: Mapping[str, list[Jump]]) -> str | None:
    """The same of segments by their names; None where none jumps. Behind a jump the angle has
    another zero, or the times are wrong.
    """
    each = [
        f"in segment {name} {said}" for name, own in segments.items() if (said := told_jumps(own))
    ]
    return f"{'; '.join(each)}. {AGAIN}" if each else None


def windows(each: Samples) -> np.ndarray:
    """The values beside each: (value, neighbour)."""
    padded = np.pad(each, NEAR)
    around = np.lib.stride_tricks.sliding_window_view(padded, 2 * NEAR + 1)
    return np.delete(around, NEAR, axis=1)


def stays(gone: Samples, at: int, size: float) -> bool:
    """Is the angle off by about that much from there on, as no spike leaves it?"""
    before, after = gone[max(at + 1 - BESIDE, 0) : at + 1], gone[at + 1 : at + 1 + BESIDE]
    return float(np.median(after) - np.median(before)) / size > STAYS
