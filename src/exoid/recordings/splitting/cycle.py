"""Where a voluntary cycle begins and returns."""

from dataclasses import replace

import numpy as np

from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.measured.segment import Segment
from exoid.recordings.motion.extent import Extent
from exoid.recordings.motion.find_free import first_movement, moving, nearest, released
from exoid.recordings.motion.signal import Signal, Speed, signal_of, speed_of
from exoid.recordings.motion.thresholds import MARKED, TURN_OF_HOLD, WILFUL


def find_cycle(segment: Segment, sensors: Sensors, period: float | None = None) -> Extent:
    """From the onset after a rest to the return into rest, or to the end of the `period` [s].

    **Raises** `Motionless` where nothing moves.
    """
    signal = signal_of(segment, sensors)
    speed = speed_of(signal)
    begin, _ = first_movement(signal, speed)
    onset, error = edge(signal, speed, begin)
    time = signal.time
    last = max(last for _, last in moving(time, speed))
    if period is None:
        back = mirrored(signal)
        mirror = replace(speed, velocity=speed.velocity[::-1])
        ended = -edge(back, mirror, time.size - 1 - last)[0]
        stop = int(np.searchsorted(time, ended, side="right"))
    else:
        ended = min(onset + period, float(time[-1]))
        stop = min(int(np.searchsorted(time, onset + period, side="right")), last + 2)
    start = nearest(time, onset)
    why = "the leg is back at rest" if stop < time.size else "the recording stops"
    held = None if onset == time[0] else max(start - 1, 0)
    return Extent(held, onset, error, start, start, stop, None, "returned", why, ended - onset)


def edge(signal: Signal, speed: Speed, first: int) -> tuple[float, float]:
    """When the leg that first moves at sample `first` left its rest [s], and its error."""
    about = float(signal.time[first])
    found = released(signal, speed, first, WILFUL)
    if found is None or found.release - signal.time[0] < MARKED:
        return float(signal.time[0]), 0.0
    if abs(found.release - about) > TURN_OF_HOLD + speed.width:
        return about, speed.width
    return found.release, found.error


def mirrored(signal: Signal) -> Signal:
    """The same motion told backwards."""
    velocity = None if signal.velocity is None else -signal.velocity[::-1]
    return replace(signal, time=-signal.time[::-1], angle=signal.angle[::-1], velocity=velocity)
