"""A column that goes over from degrees to radians, or back, in the middle of a file."""

import numpy as np

from exoid.recordings.measured.samples import Samples

DEGREES = 180 / np.pi  # in a radian
NEAR = 0.01  # of the ratio, by which the leg and the noise move it from one sample to the next
LEAST = 0.5  # rad, of the jump: a smaller one may be anything
ALONE = 5.0  # times the next greatest step


def unit_change(time: Samples, angle: Samples) -> float | None:
    """When [s] an angle becomes so much smaller or greater at once; None where it does not."""
    known = ~np.isnan(angle)
    time, angle = time[known], angle[known]
    steps = np.abs(np.diff(angle))
    if steps.size < 2:
        return None
    at = int(np.argmax(steps))
    small, great = sorted((angle[at], angle[at + 1]), key=abs)
    alone = steps[at] > max(LEAST, ALONE * float(np.delete(steps, at).max()))
    if not alone or abs(small * DEGREES - great) > NEAR * abs(great):
        return None
    return float(time[at + 1])
