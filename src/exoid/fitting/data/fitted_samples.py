"""Which samples of a segment are fitted: what moved freely, or what the paper kept."""

from dataclasses import dataclass
from typing import Literal

import numpy as np

from exoid.recordings.measured.segment import Segment
from exoid.recordings.motion.drops import find_drop
from exoid.recordings.motion.extent import Extent, Motionless
from exoid.recordings.recording import Recording
from exoid.recordings.signal.condition import best_velocity, clip
from exoid.recordings.splitting.cycle import find_cycle

Clip = Literal["free", "paper"]
FEWEST = 10  # samples that a movement must have to be fitted


@dataclass(frozen=True)
class Portion:
    """Samples by number, times in s on the segment's clock."""

    start: int  # where the simulation begins
    free: int  # the first sample that weighs
    stop: int
    onset: float  # when the clock of Eq. 10 starts
    period: float  # of the cycle; nan where there is none
    extent: Extent | None


def portion(recording: Recording, number: int, kind: str, clip: Clip, name: str) -> Portion:
    """The samples to fit.

    What a measured torque moves is kept whole: its rest tells about the torque. "paper" cuts off
    the ends that are slower than 20 deg/s, as Eq. 3-4 were applied.
    """
    segment = recording.segments[number]
    if kind == "measured":
        return Portion(0, 0, segment.time.size, 0.0, np.nan, None)
    try:
        found = found_in(recording, number, kind)
        part = Portion(
            found.start, found.free, found.stop, *clock(recording, number, kind, found), found
        )
        if clip == "paper":
            part = published(segment, part, kind)
    except Motionless as fault:
        raise Motionless(f"segment {name}: {fault}") from fault
    except ValueError as fault:
        raise ValueError(f"segment {name}: {fault}") from fault
    if part.stop - part.free < FEWEST:
        raise Motionless(
            f"segment {name} moves freely in {max(part.stop - part.free, 0)} samples; {FEWEST} are "
            "the least. Check its marks, its period and its units."
        )
    return part


def found_in(recording: Recording, number: int, kind: str) -> Extent:
    if kind == "active":
        segment = recording.segments[number]
        return find_cycle(segment, recording.sensors, recording.cycle_period(number))
    return find_drop(recording, number)


def clock(recording: Recording, number: int, kind: str, found: Extent) -> tuple[float, float]:
    """When the clock of Eq. 10 starts, and how long the cycle lasts [s]."""
    period = recording.cycle_period(number)
    if kind != "active":
        return float(recording.segments[number].time[0]), np.nan if period is None else period
    return found.release, found.duration if period is None else period


def published(segment: Segment, part: Portion, kind: str) -> Portion:
    """From the first to the last sample that moves faster than 20 deg/s."""
    kept = clip(best_velocity(segment))
    stop = min(kept.stop, part.stop) if kind == "active" else kept.stop
    return Portion(kept.start, kept.start, stop, part.onset, part.period, part.extent)
