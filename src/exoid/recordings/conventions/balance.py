"""Where a swinging leg is in balance, and how hard it is drawn there: a regression, no fit."""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from exoid.recordings.conventions.file_clock import measured
from exoid.recordings.recording import Segment
from exoid.recordings.samples import Samples

WINDOW = 0.4  # s, a third of a swing
STRIDE = 0.05  # s between windows
FEWEST = 8  # samples of a window
MOST = 400  # windows, of however long a recording
LEAST = 6  # windows
MOVING = 0.15  # of how far the leg moves at all, that it moves within a window


@dataclass(frozen=True)
class Balance:
    """What draws a leg: phi'' = -pull sin(phi - angle) - d phi'."""

    angle: float  # rad, as the file counts it
    angle_error: float  # rad
    pull: float  # 1/s^2: m l g / J, and what a spring adds
    pull_error: float
    explained: float  # share of the acceleration's mean square


@lru_cache(maxsize=64)  # asked of every drop by each check of how its angle is counted
def balance(segment: Segment) -> Balance | None:
    """By regression over the windows in which the leg moves; None where they are too few.

    The equation is multiplied by psi = s^3 (1 - s)^3, with s from 0 to 1 over a window, and
    integrated by parts, so that no sample is differentiated (the weak form):
    int psi'' phi = -a int psi cos(phi) - b int psi sin(phi) + d int psi' phi, whence the pull
    is sqrt(a^2 + b^2), and the balance at atan2(-a, b). Zero and sign of the angle are free.
    """
    rows = weak_form(segment)
    if rows.shape[0] < LEAST:
        return None
    left, right = rows[:, 0], rows[:, 1:]
    found, _, rank, _ = np.linalg.lstsq(right, left)
    if rank < right.shape[1]:
        return None
    a, b = (float(each) for each in found[:2])
    pull = float(np.hypot(a, b))
    missed = left - right @ found
    # Windows overlap: only one in WINDOW / STRIDE tells something new.
    free = max(rows.shape[0] * STRIDE / WINDOW - right.shape[1], 1.0)
    scatter = float(missed @ missed) / rows.shape[0] * (rows.shape[0] * STRIDE / WINDOW) / free
    covariance = (scatter * WINDOW / STRIDE * np.linalg.inv(right.T @ right))[:2, :2]
    turn, along = np.array([-b, a]) / pull**2, np.array([a, b]) / pull
    return Balance(
        angle=float(np.arctan2(-a, b)),
        angle_error=float(np.sqrt(turn @ covariance @ turn)),
        pull=pull,
        pull_error=float(np.sqrt(along @ covariance @ along)),
        explained=1 - float(missed @ missed) / float(left @ left),
    )


def weak_form(segment: Segment) -> NDArray[np.float64]:
    """A row for every window: int psi'' phi, -int psi cos(phi), -int psi sin(phi), int psi' phi."""
    time, angle = measured(segment)
    rows = []
    stride = max(STRIDE, (time[-1] - time[0]) / MOST)
    for begin in np.arange(time[0], time[-1] - WINDOW, stride):
        part = slice(*np.searchsorted(time, [begin, begin + WINDOW]))
        if part.stop - part.start >= FEWEST and np.ptp(angle[part]) > MOVING * np.ptp(angle):
            rows.append(window(time[part] - begin, angle[part]))
    return np.array(rows).reshape(-1, 4)


def window(time: Samples, angle: Samples) -> list[float]:
    """The integrals of one window; the angle counts from its mean where it stands alone."""
    s = time / WINDOW
    hump = s * (1 - s)
    psi = hump * hump * hump
    slope = 3 * hump * hump * (1 - 2 * s) / WINDOW
    bend = 6 * hump * (1 - 5 * hump) / WINDOW**2
    apart = angle - angle.mean()
    each = (bend * apart, -psi * np.cos(angle), -psi * np.sin(angle), slope * apart)
    whole = np.concatenate([[0.0], time, [WINDOW]])
    share = (whole[2:] - whole[:-2]) / 2  # the trapezoid rule; at the ends all of them are 0
    return [float(share @ values) for values in each]
