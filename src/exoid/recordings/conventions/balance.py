"""Where a swinging leg is in balance, and how hard it is drawn there: a regression, no fit. And
which segments swing at all.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from exoid.recordings.conventions.file_clock import measured
from exoid.recordings.measured.samples import Samples
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from exoid.recordings.remembered import remembered
from exoid.recordings.signal.condition import RINGING, SMOOTHING, reversals
from exoid.recordings.signal.local_line import local_line

WINDOW = 0.4  # s, a third of a swing
STRIDE = 0.05  # s between windows
FEWEST = 8  # samples of a window
MOST = 400  # windows, of however long a recording
LEAST = 6  # windows
COLUMNS = 6  # integrals of a window
MOVING = 0.15  # of how far the leg moves at all, that it moves within a window


@dataclass(frozen=True)
class Balance:
    """What draws a leg: phi'' = -pull sin(phi - angle) - d phi'."""

    angle: float  # rad, as the file counts it
    angle_error: float  # rad
    pull: float  # 1/s^2: m l g / J, and what a spring adds
    pull_error: float
    explained: float  # share of the acceleration's mean square


@remembered  # asked of every drop by each check of how its angle is counted
def balance(segment: Segment) -> Balance | None:
    """By regression over the windows in which the leg moves; None where they are too few.

    The equation is multiplied by psi = s^3 (1 - s)^3, with s from 0 to 1 over a window, and
    integrated by parts, so that no sample is differentiated (the weak form):
    int psi'' phi = -a int psi cos(phi) - b int psi sin(phi) + d int psi' phi, whence the pull
    is sqrt(a^2 + b^2), and the balance at atan2(-a, b). Zero and sign of the angle are free.
    """
    rows = weak_form(*measured(segment))[:, :4]
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
    # The pseudo-inverse: its square is no less than 0, however alike the columns are.
    each = np.sqrt(scatter * WINDOW / STRIDE) * np.linalg.pinv(right)[:2]
    turn, along = np.array([-b, a]) / pull**2, np.array([a, b]) / pull
    return Balance(
        angle=float(np.arctan2(-a, b)),
        angle_error=float(np.linalg.norm(turn @ each)),
        pull=pull,
        pull_error=float(np.linalg.norm(along @ each)),
        explained=1 - float(missed @ missed) / float(left @ left),
    )


def middle(each: list[Balance]) -> Balance:
    """The one in the middle; of two, the first."""
    return sorted(each, key=lambda one: one.pull)[(len(each) - 1) // 2]


@remembered
def swings(segment: Segment) -> bool:
    """Does the leg turn around? Whichever sign its angle has."""
    time, angle = measured(segment)
    smooth = local_line(time, angle, 2 * SMOOTHING)[0]
    return bool(reversals(smooth, RINGING * float(np.ptp(smooth))))


def swinging(recording: Recording, numbers: list[int]) -> list[int]:
    """Those of some segments that swing; all where none does."""
    return [each for each in numbers if swings(recording.segments[each])] or numbers


def weak_form(time: Samples, angle: Samples) -> NDArray[np.float64]:
    """A row for every window: int psi'' phi, -int psi cos(phi), -int psi sin(phi), int psi' phi,
    and of a spring -int psi phi, -int psi.
    """
    stride = max(STRIDE, (time[-1] - time[0]) / MOST)
    begin = np.arange(time[0], time[-1] - WINDOW, stride)
    first, last = np.searchsorted(time, [begin, begin + WINDOW])
    told = last - first >= FEWEST
    if not told.any():
        return np.empty((0, COLUMNS))
    begin, first, last = begin[told], first[told], last[told]
    edges = np.stack([first, last], axis=1).ravel()[: -1 if last[-1] == time.size else None]
    travel = (each.reduceat(angle, edges)[::2] for each in (np.maximum, np.minimum))
    moves = np.subtract(*travel) > MOVING * np.ptp(angle)
    return integrals(time, angle, begin[moves], first[moves], last[moves])


def integrals(
    time: Samples, angle: Samples, begin: Samples, first: NDArray[np.int_], last: NDArray[np.int_]
) -> NDArray[np.float64]:
    """Those of windows from `begin` [s] on, with the samples from `first` to before `last`.

    The angle counts from its mean where it stands alone. By the trapezoid rule; at both ends all is
    0, and so it is where a window has no more samples.
    """
    if not begin.size:
        return np.empty((0, COLUMNS))
    at = first[:, None] + np.arange(int((last - first).max()))
    inside = at < last[:, None]
    at = np.minimum(at, time.size - 1)
    since, angle = np.where(inside, time[at] - begin[:, None], WINDOW), angle[at]
    whole = np.pad(since, [(0, 0), (1, 1)], constant_values=((0, 0), (0, WINDOW)))
    share = (whole[:, 2:] - whole[:, :-2]) / 2
    s = since / WINDOW
    hump = s * (1 - s)
    psi = hump * hump * hump
    slope = 3 * hump * hump * (1 - 2 * s) / WINDOW
    bend = 6 * hump * (1 - 5 * hump) / WINDOW**2
    mean = np.sum(angle, axis=1, where=inside, keepdims=True) / inside.sum(axis=1, keepdims=True)
    apart = angle - mean
    turned = (bend * apart, -psi * np.cos(angle), -psi * np.sin(angle), slope * apart)
    each = (*turned, -psi * angle, -psi)
    return np.stack([np.einsum("wt,wt->w", share, values) for values in each], axis=1)
