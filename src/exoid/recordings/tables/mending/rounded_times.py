"""Times with so few digits that samples which follow each other have the same.

Samples that are taken evenly lie on a line over their number, and rounding moves none of their
times by more than its step.
"""

import numpy as np

from exoid.recordings.measured.samples import Samples

FEWEST = 50  # samples, as of any times that are taken for even
SURE = 4.0  # standard errors of the ends of a line through rounded times


def unrounded(time: Samples) -> Samples | None:
    """Even times [s] in place of rounded ones; None where none is there twice, or these are not
    even ones that were rounded.
    """
    steps = np.diff(time)
    if time.size < FEWEST or not np.isfinite(time).all() or steps.min() < 0:
        return None
    if steps.all() or not steps.any():
        return None
    number = np.arange(time.size, dtype=float)
    even = time[0] + np.polyfit(number, time - time[0], 1)[0] * number
    rounding = float(steps[steps > 0].min())
    most = (1 + SURE / np.sqrt(3 * time.size)) * rounding
    return even if np.ptp(time - even) < most else None
