"""The push that turns a swing around: what a stop, or the end of a joint's range, does to an angle.

A force of half a sine, which lasts for `lasting` s about an instant and gives a speed of 1 rad/s:

    s(x) = w / 2 (u - sin(pi u) / pi),  u = (x + w / 2) / w within [0, 1];  s(x) = x beyond
"""

import numpy as np
from numpy.typing import NDArray

from exoid.recordings.measured.samples import Samples

LASTING = (0.0, 0.01, 0.02, 0.03, 0.04, 0.05, 0.06, 0.07, 0.08, 0.1, 0.12, 0.14)  # s, tried
REACH, STEP = 0.05, 0.001  # s from a turn within which a push is looked for, and between two tried
INSTANTS = np.arange(-REACH, REACH + STEP / 2, STEP)


def pushed(since: Samples, lasting: float) -> Samples:
    """How far a push has moved a leg, so long after its middle [s]."""
    if lasting == 0.0:
        return np.maximum(since, 0.0)
    share = np.clip(since / lasting + 0.5, 0.0, 1.0)
    within = lasting / 2 * (share - np.sin(np.pi * share) / np.pi)
    return within + np.maximum(since - lasting / 2, 0.0)


def greatest(lasting: float) -> float:
    """How much it accelerates a leg in its middle [1/s], a blow as the shortest that is told."""
    return np.pi / 2 / (lasting or LASTING[1] / 2)


def every_push(time: Samples) -> NDArray[np.float64]:
    """All that are tried, at these times after a turn (push, sample)."""
    since = time - INSTANTS[:, None]
    return np.concatenate([pushed(since, each) for each in LASTING])
