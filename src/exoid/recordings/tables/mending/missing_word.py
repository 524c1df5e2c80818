"""A number that stands for none, as -999: loggers and other programs write it into empty cells."""

import numpy as np

from exoid.recordings.measured.samples import Samples

WORDS = (999.0, 9999.0, 99999.0)  # of either sign
UNITS = (1.0, np.pi / 180)  # rad and degrees
EXACT = 1e-9  # of itself, to which a number is one of them


def missing_word(samples: Samples) -> float | None:
    """The number [rad or rad/s] that stands for a missing sample; None where there is none.

    It is farther from all others than these are from each other: no signal goes there and back.
    """
    for value in map(float, (np.nanmin(samples), np.nanmax(samples))):
        if named(value) is None:
            continue
        others = samples[~np.isnan(samples) & (samples != value)]
        if others.size and np.abs(others - value).min() > np.ptp(others):
            return value
    return None


def named(value: float) -> str | None:
    """As its file says it; None where it is an ordinary number."""
    for unit in UNITS:
        for word in WORDS:
            if np.isclose(abs(value), word * unit, rtol=EXACT, atol=0):
                return f"{np.copysign(word, value):.0f}"
    return None
