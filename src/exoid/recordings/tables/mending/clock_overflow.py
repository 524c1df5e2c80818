"""A counter that begins again at 0 when it is full, as `micros()` and `millis()` of a logger do."""

import numpy as np

from exoid.recordings.measured.samples import Samples

TICKS = {"microseconds": 1e-6, "milliseconds": 1e-3}  # s
FULL = 2**32  # ticks
LONGEST = 1.0  # s between two samples: a clock that was set, or began again, is off by other times


def going_on(time: Samples) -> tuple[Samples, str] | None:
    """Times [s] that go on where their counter was full, and its ticks in words; None where none
    was, or where they also go back by anything else.
    """
    steps = np.diff(time)
    back = steps <= 0
    for ticks, tick in TICKS.items():
        turned = steps[back] + FULL * tick
        if turned.size and ((turned > 0) & (turned < LONGEST)).all():
            return time + FULL * tick * np.concatenate([[0], np.cumsum(back)]), ticks
    return None
