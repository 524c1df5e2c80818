"""At which rate a recording was sampled."""

from collections.abc import Iterable

import numpy as np

from exoid.recordings.measured.segment import Segment

GAP = 1.5  # of the usual step, beyond which samples are missing


def rate_of(segments: Iterable[Segment]) -> float:
    """Samples in a second [Hz]: the mean, as times are rounded; without what is missing."""
    steps = np.concatenate([np.diff(each.time) for each in segments])
    return float(1 / steps[steps < GAP * np.median(steps)].mean())
