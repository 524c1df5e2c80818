"""The noise that a signal had before it was smoothed or interpolated, told from errors that
neighbours share.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from exoid.recordings.measured.samples import FAR, FEWEST, Samples, quantile, robust_deviation
from exoid.recordings.signal.neighbours import NEIGHBOURS, Known, astride, jumps_of

SHARED = 2.0  # times white noise and motion, that wider neighbourhoods must show
CLOSE, WIDEST = 0.051, 0.1  # s between neighbours: where smoothing shows at last, and motion does
RESTING = 0.13  # s, the same of both in a leg at rest: errors that a filter of 4 Hz leaves
FURTHER, ALIKE = 4, 1.25  # samples, between neighbours that show no more noise than these times
ENDING = 0.5  # s that tell where a movement ends
STILL = 0.1  # of how far a leg swings most of the time, that it swings at rest at most
STRIDES = 60  # neighbourhoods that are tried at most
WIDER = 1.5  # times as far, over which growth tells noise from motion
FLAT, STEEP = 1.0, 3.0  # powers of the distance: of noise beyond its filter, and of motion
SWING, QUICK = 0.2, 8.0  # rad, rad/s: how much, and how fast, a leg swings most of the time
OF_ANGLE, OF_RATE = SWING, SWING * QUICK  # rad, rad/s: how much the signal of a sensor swings then
TELLING = 20_000  # samples of all segments, which tell a scatter to 0.6 %
HINTING, HINT = 500, 0.7  # samples that tell it to 4 %, and the share of the limit to look closer
TURN = 0.2  # s between jumps, at least on average: steps that come faster are of an interpolation
QUIET = np.radians(0.003)  # of an angle: less than encoders and cameras on a leg scatter


class Reach(NamedTuple):
    """How far neighbours may be apart [s], and how steeply what they share may grow with that."""

    close: float  # where smoothing shows at last
    widest: float  # where noise is told
    steepest: float  # power of the distance


def smoothed_or_not(
    known: list[Known], white: float, swing: float, *, driven: bool, rounding: float
) -> tuple[float, float]:
    """`smoothed` by all samples, and by those of rests, which nothing but noise moves: what shows
    more noise. Where a filter has left none, it has also taken from the motion.

    What a torque has `driven` may move as quickly as the errors that a filter leaves: its samples
    were smoothed only where noise shows that no motion makes.
    """
    if driven and plain(known, white, rounding):
        return white, 0.0
    step, still = known_step(known), STILL * swing
    near = max(CLOSE, 2.1 * step)  # of a slow camera there is nothing nearer
    steepest = STEEP if driven else np.inf
    found = smoothed(known, step, white, swing, Reach(near, WIDEST, steepest))
    rests = [rest for each in known if (rest := at_rest(each, still)) is not None]
    if not rests or found[0] < QUIET:
        return found
    return max(found, smoothed(rests, step, white, still, Reach(RESTING, RESTING, steepest)))


def plain(known: list[Known], white: float, rounding: float) -> bool:
    """Is there more white noise than `rounding` makes, and the same beside neighbours four samples
    apart? Whoever smooths leaves no other.
    """
    told = np.concatenate([each.errors(FURTHER)[1] for each in known])
    if told.size < 2 * FEWEST or white < ALIKE * rounding:
        return False
    return robust_deviation(told) < ALIKE * white


def at_rest(known: Known, still: float) -> Known | None:
    """What is known of the rest at the end of a movement, in which the signal goes no farther than
    `still` from where it ends; None where that is too short for neighbours.
    """
    end = quantile(known.values[np.searchsorted(known.time, known.time[-1] - ENDING) :])
    away = np.flatnonzero(np.abs(known.values - end) > still)
    rest = slice(int(away[-1]) + 1 if away.size else 0, None)
    if known.values[rest].size <= 2 * NEIGHBOURS:
        return None
    changes = None if known.changes is None else known.changes[rest]
    return Known(known.places[rest], known.time[rest], known.values[rest], changes)


def known_step(known: list[Known]) -> float:
    """The usual time between known samples [s]: where a gyro is faster, an angle has empty cells
    between them.
    """
    return quantile(np.concatenate([np.diff(each.time) for each in known]))


def smoothed(
    known: list[Known], step: float, white: float, swing: float, reach: Reach
) -> tuple[float, float]:
    """The noise that a signal had before it was smoothed, and over how many seconds [s] its errors
    are alike now; `white` and 0 where neighbours share nothing. `step` is between known samples.

    White noise shows the same beside neighbours far and near, smoothed noise ever more. As many
    independent errors as there are such stretches tell a mean as well as white noise would that is
    larger by the root of the samples in a stretch. Neighbours on both sides of a jump (a release, a
    catch, play at a turn) share nothing that smoothing left: they do not count.
    """
    jumps = [jumps_of(each, FAR * white, TURN) for each in known]
    tried = np.unique(np.geomspace(2, max(reach.widest / step, 2), STRIDES).astype(int))

    def scatter(stride: int, most: int) -> float:
        """nan where too few samples tell."""
        found = [each.errors(stride, most // len(known)) for each in known]
        clear = [
            errors[~astride(jump, inner, NEIGHBOURS * stride)]
            for jump, (inner, errors) in zip(jumps, found, strict=True)
        ]
        told = np.concatenate(clear)
        return robust_deviation(told) if told.size >= 2 * FEWEST else np.nan

    bend = swing * (2 * np.sin(QUICK * tried * step / 2)) ** 6 / 20
    shared = SHARED * np.hypot(white, bend)
    near = int(np.sum(tried * step <= reach.close))
    most, few = (max(each, FEWEST * len(known)) for each in (TELLING, HINTING))
    hints = (scatter(stride, few) for stride in tried[:near].tolist())
    if not any(hint > HINT * limit for hint, limit in zip(hints, shared.tolist(), strict=False)):
        return white, 0.0
    found = np.array([scatter(stride, most) for stride in tried.tolist()])
    told = found > shared  # nan compares false
    if not told[:near].any():
        return white, 0.0
    excess = np.sqrt(np.maximum(found**2, 2 * white**2) - white**2)
    told &= tried <= flattens(tried, excess, int(np.argmax(told)), reach.steepest)
    if not told.any():
        return white, 0.0
    at = int(np.argmax(np.where(told, found, 0.0)))
    return float(found[at] * np.sqrt(tried[at])), float(tried[at] * step)


def flattens(tried: NDArray[np.int_], excess: Samples, first: int, steepest: float) -> float:
    """The last stride where an excess over white noise is flat, or flattest: grown little since
    neighbours `WIDER` times as near; 0 where it grows more steeply everywhere, or nothing tells.

    What neighbours miss of a motion grows with the sixth power of their distance, and beside a turn
    of friction with the square, ever more often; noise flattens beyond its filter.
    """
    before = np.searchsorted(tried, tried / WIDER, side="right") - 1
    pairs = np.flatnonzero((before >= first) & ~np.isnan(excess))
    if steepest == np.inf:
        return np.inf
    if not pairs.size:
        return 0.0
    before = before[pairs]
    grown = np.log(excess[pairs] / excess[before]) / np.log(tried[pairs] / tried[before])
    flat = pairs[grown <= max(grown.min(), FLAT)]
    return float(tried[flat[-1]]) if grown.min() < steepest else 0.0
