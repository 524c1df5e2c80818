"""What cubic splines follow of signals, by least squares, of hundreds of signals at once.

SciPy's spline takes 0.3 s of every command to be loaded. Between two knots a sample adds to the
normal equations no more than moments: sums of u^k and of y u^k, with u from 0 to 1 there.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

ORDER = 4  # numbers of a cubic
POWERS = np.arange(ORDER)
NODES = POWERS / (ORDER - 1)  # of u, that tell a cubic
TOLD = np.linalg.inv(NODES[:, None] ** POWERS)  # (power, value at a node)
AT_ONCE = 2**16  # gaps between knots: 30 MB
ALIKE = 1e-9  # of a gap, to which those are of one length whose splines are the same
LITTLE = 2**17  # numbers of whole matrices below which these are solved sooner than bands
NOTHING = 1e-12  # of the greatest diagonal, below which no sample tells a number of a spline

Samples = NDArray[np.float64]
Table = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Gaps:
    """A signal by the gaps between its knots, which are as dense as its samples, pauses too."""

    knots: Samples  # the first and the last four times
    of: NDArray[np.int_]  # in which gap each sample is
    u: Samples  # where in it, from 0 to 1
    moments: Table  # (sum, gap): of u^0 to u^6, then for u^0 to u^3 of y u^k of every signal y

    @property
    def count(self) -> int:
        return self.moments.shape[1]


def follow(signals: list[tuple[Samples, Table]], knot: float) -> list[Table]:
    """What a spline with a knot every `knot` s, but no closer than samples, follows of each signal
    (time first) beside its times.
    """
    each = [gaps(time, np.atleast_2d(signal.T), knot) for time, signal in signals]
    found: list[Table] = [np.empty(0)] * len(each)
    left = sorted(range(len(each)), key=lambda number: each[number].count)
    while left:  # those with the most gaps first, beside others of about as many
        size = max(AT_ONCE // each[left[-1]].count, 1)
        left, some = left[:-size], left[-size:]
        for number, cubics in zip(some, fitted([each[number] for number in some]), strict=True):
            found[number] = values(each[number], cubics).T.reshape(signals[number][1].shape)
    return found


def gaps(time: Samples, signal: Table, knot: float) -> Gaps:
    size = time.size - 1
    count = min(max(int((time[-1] - time[0]) / knot), 1), size)
    number = np.arange(time.size)
    inner = np.interp(np.arange(1, count) * (size / count), number, time)
    knots = np.concatenate([[time[0]] * ORDER, inner, [time[-1]] * ORDER])
    of = np.minimum(number * count // size, count - 1)
    begin, length = knots[ORDER - 1 : -ORDER], np.diff(knots[ORDER - 1 : 1 - ORDER])
    u = (time - begin[of]) / length[of]
    terms = np.empty((2 * ORDER - 1 + ORDER * signal.shape[0], time.size))
    terms[0] = 1.0
    for power in range(1, 2 * ORDER - 1):
        np.multiply(terms[power - 1], u, out=terms[power])
    shared = terms[2 * ORDER - 1 :].reshape(ORDER, *signal.shape)
    np.multiply(terms[:ORDER, None], signal, out=shared)
    first = -(-np.arange(count) * size // count)
    return Gaps(knots, of, u, np.add.reduceat(terms, first, axis=1))


def shapes(knots: Samples) -> Table:
    """The cubics of the four B-splines in every gap: (spline, power of u, gap)."""
    around = [knots[1 + lag : lag - 2 * ORDER + 2 or None] for lag in range(2 * ORDER - 2)]
    begin, end = around[ORDER - 2], around[ORDER - 1]
    at = begin + NODES[:, None] * (end - begin)
    splines = [np.ones_like(at)]
    for degree in range(1, ORDER):
        higher = [np.zeros_like(at) for _ in range(degree + 1)]
        for number, spline in enumerate(splines):
            low, high = around[ORDER - 1 - degree + number], around[ORDER - 1 + number]
            share = spline / (high - low)
            higher[number] += (high - at) * share
            higher[number + 1] += (at - low) * share
        splines = higher
    return np.stack([TOLD @ spline for spline in splines])


# Of gaps of one length: the first three, all in the middle, the last three.
EVENLY = shapes(np.array([0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 7, 7, 7.0]))


def shapes_of(one: Gaps) -> Table:
    """`shapes`, which are the same between knots that are evenly apart."""
    steps = np.diff(one.knots[ORDER - 1 : 1 - ORDER])
    if one.count < EVENLY.shape[2] or np.ptp(steps) > ALIKE * steps[0]:
        return shapes(one.knots)
    number = np.arange(one.count)
    return EVENLY[..., np.minimum(number, 3) + np.maximum(number - one.count + 4, 0)]


def fitted(some: list[Gaps]) -> list[Table]:
    """The cubics of every signal: (power of u, y, gap)."""
    count = max(one.count for one in some)
    shape = np.zeros((ORDER, ORDER, count, len(some)))
    moments = np.zeros((some[0].moments.shape[0], count, len(some)))
    for number, one in enumerate(some):
        shape[..., : one.count, number] = shapes_of(one)
        moments[:, : one.count, number] = one.moments
    shared = moments[2 * ORDER - 1 :].reshape(ORDER, -1, count, len(some))
    gram = np.einsum("spgn,pqgn->sqgn", shape, moments[POWERS[:, None] + POWERS])
    gram = np.einsum("sqgn,tqgn->stgn", gram, shape)
    right = np.einsum("spgn,pygn->sgyn", shape, shared)
    bands = np.zeros((count + 2 * ORDER - 2, ORDER, len(some)))
    sides = np.zeros((bands.shape[0], *right.shape[2:]))
    for one in range(ORDER):
        sides[one : one + count] += right[one]
        for other in range(one, ORDER):
            bands[one : one + count, other - one] += gram[one, other]
    few = len(some) * bands.shape[0] ** 2 < LITTLE
    numbers = (solved_whole if few else solved)(bands, sides)
    near = np.stack([numbers[one : one + count] for one in range(ORDER)])
    cubics = np.einsum("spgn,sgyn->pygn", shape, near)
    return [cubics[..., : one.count, number] for number, one in enumerate(some)]


def solved(bands: Table, sides: Table) -> Table:
    """Of many symmetric systems side by side (last axis), by Cholesky and in place; `bands` (row,
    distance) from the diagonal on. A number that nothing tells is 0.
    """
    size = bands.shape[0] - ORDER + 1
    least = NOTHING * bands[:, 0].max(axis=0)
    for row in range(size):
        told = bands[row, 0] > least
        bands[row] /= np.where(told, np.sqrt(np.maximum(bands[row, 0], least)), np.inf)
        bands[row, 0] = np.where(told, bands[row, 0], np.inf)
        sides[row] /= bands[row, 0]
        for away in range(1, ORDER):
            one = bands[row, away]
            bands[row + away, : ORDER - away] -= one * bands[row, away:]
            sides[row + away] -= one * sides[row]
    for row in reversed(range(size)):
        for away in range(1, ORDER):
            sides[row] -= bands[row, away] * sides[row + away]
        sides[row] /= bands[row, 0]
    return sides


def solved_whole(bands: Table, sides: Table) -> Table:
    """The same, each as a whole matrix: of a few short ones that is done before Python has gone
    through the rows.
    """
    size = bands.shape[0] - ORDER + 1
    told = bands[:size, 0] > NOTHING * bands[:, 0].max(axis=0)
    whole = np.zeros((bands.shape[2], size, size))
    row = np.arange(size)
    for away in range(ORDER):
        own = bands[: size - away, away] * told[: size - away] * told[away:]
        whole[:, row[: size - away], row[away:]] = whole[:, row[away:], row[: size - away]] = own.T
    whole[:, row, row] += ~told.T
    right = np.where(told[:, None], sides[:size], 0.0)
    sides[:size] = np.moveaxis(np.linalg.solve(whole, np.moveaxis(right, -1, 0)), 0, -1)
    return sides


def values(one: Gaps, cubics: Table) -> Table:
    """Of every signal at every time."""
    *lower, found = (cubic[:, one.of] for cubic in cubics)
    for cubic in reversed(lower):
        found = found * one.u + cubic
    return found
