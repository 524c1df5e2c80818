"""What is in the residual of a fit: the sensors' white noise, and what the model misses.

A torque that the model lacks moves the leg along with what its parameters do, so most of its
effect hides in the parameters and little is left in the residual: neither its size nor its
autocorrelation can tell how wrong they are. Here the missing torque, or a slow error of the
encoder, is a Gaussian process u(t) with a Matern covariance; its size and correlation time are
those of greatest restricted likelihood (Patterson & Thompson, Biometrika 58(3), 1971), which allows
for what the parameters absorbed.
"""

import numpy as np

from exoid.fitting.misfit.gram import CAUSES, UNIT, Cause, Gram, Grams
from exoid.fitting.misfit.gram_matrices import Times, modes
from exoid.fitting.misfit.missed import Missed
from exoid.fitting.misfit.uncertainty import whitening

CORRELATED = (0.025, 0.05, 0.1, 0.2, 0.4, 0.8)  # s
SIZES = np.logspace(-7, 4, 12)  # of u's variance over that of the noise, in units of the gram
FINER = np.logspace(-0.8, 0.8, 9)  # a fifth of a decade apart
LEAST = 1e-15  # share of what tells a direction that a process leaves: below is rounding
CLEAR = 4.0  # gain of log likelihood below which the noise alone explains the residual
# Gain at a decade's grid from which on it is worth to look closer: that shows about half of what is
# between its points, for however few or many nodes.
PROMISING = CLEAR / 4


def explain(grams: list[Grams], most: dict[Cause, float], samples: int, size: int) -> Missed:
    """The noise and the process of greatest restricted likelihood.

    The unknowns of the segments are among `size` coordinates. `most` bounds the deviation: what
    nearly hides in the parameters may else grow without limit.
    """

    each: dict[Cause, Likelihood] = {
        cause: Likelihood([one[cause] for one in grams], np.array(CORRELATED), samples, size)
        for cause in CAUSES
    }
    plain = float(each["torque"](np.zeros(1))[0, 0])
    found: tuple[Cause | None, int, float] = (None, 0, 0.0)
    best = plain + CLEAR
    for cause, likelihood in each.items():
        bound = (most[cause] / UNIT[cause]) ** 2
        ratios, values = likelihood.greatest(bound, plain + PROMISING)
        top = int(np.argmax(values))
        if values[top] > best:
            best = float(values[top])
            found = cause, top, float(ratios[top])
    cause, top, ratio = found
    noise = float(each[cause or "torque"].noise_beside(ratio)[top])
    return Missed(cause, CORRELATED[top], ratio, noise, best)


class Likelihood:
    """The restricted log likelihood of a process' size, with the noise at its best; of several
    correlation times by a leading axis.

    What the data determine at all is decided once, without the process: that it hides a direction
    does not make it one that nothing tells.
    """

    def __init__(self, grams: list[Gram], correlated: Times, samples: int, size: int):
        plain = np.zeros((size, size))
        for each in grams:
            plain[np.ix_(each.place, each.place)] += each.fitted[:-1, :-1]
        basis, unit = whitening(plain)
        self.basis = basis / unit[:, None]
        self.freedom = samples - basis.shape[1]
        fixed = [outer(self.told(each, each.outside)).sum(axis=0) for each in grams]
        self.outside = np.sum(fixed, axis=0)
        self.parts = []
        for each in grams:
            sizes, axes = modes(each, correlated)
            inside = np.swapaxes(axes, -1, -2) @ self.told(each, each.inside)
            self.parts.append((sizes, outer(inside)))

    def told(self, each: Gram, rows: np.ndarray) -> np.ndarray:
        """Rows of (A, r) along what the data determine."""
        return np.column_stack([rows[:, :-1] @ self.basis[each.place], rows[:, -1]])

    def greatest(self, most: float, enough: float) -> tuple[np.ndarray, np.ndarray]:
        """The variance ratios up to `most` where it is greatest, and its values there: to a decade,
        and where one of these is `enough` to a fifth of one.
        """
        coarse = np.append(SIZES[most > SIZES], most)
        values = self(coarse)
        at, top = coarse[np.argmax(values, axis=-1)], values.max(axis=-1)
        if top.max() < enough:
            return at, top
        near = np.minimum(at[..., None] * FINER, most)
        values = self(near)
        at = np.take_along_axis(near, np.argmax(values, axis=-1)[..., None], axis=-1)
        return at[..., 0], values.max(axis=-1)

    def __call__(self, ratios: np.ndarray) -> np.ndarray:
        ratios = np.atleast_1d(ratios)
        grown = sum(np.log1p(by(ratios, sizes)).sum(axis=-1) for sizes, _ in self.parts)
        absorbed, left = self.profiled(ratios)
        return restricted(grown + absorbed, left, self.freedom)

    def profiled(self, ratios: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The log determinant of A'V^-1 A over that of A'A, and the least r'V^-1 r that the
        parameters leave, for each ratio; V is the covariance over the noise.
        """
        total = self.total(ratios)
        values, axes = np.linalg.eigh(total[..., :-1, :-1])
        values = np.maximum(values, LEAST)
        along = np.einsum("...ij,...i->...j", axes, total[..., :-1, -1])
        left = total[..., -1, -1] - np.sum(along**2 / values, axis=-1)
        return np.log(values).sum(axis=-1), left

    def total(self, ratios: np.ndarray) -> np.ndarray:
        """(A, r)'V^-1 (A, r) for each ratio, along what the data determine."""
        total, count = self.outside, len(self.outside)
        for sizes, inside in self.parts:
            share = 1 / (1 + by(ratios, sizes))
            each = share @ inside.reshape(*inside.shape[:-2], -1)
            total = total + each.reshape(*each.shape[:-1], count, count)
        return total

    def noise_beside(self, ratio: float) -> np.ndarray:
        """The white noise over the declared one; sensors are no better than declared."""
        left = self.profiled(np.array([ratio]))[1][..., 0]
        return np.sqrt(np.maximum(1.0, left / self.freedom))


def by(ratios: np.ndarray, sizes: np.ndarray) -> np.ndarray:
    """Every ratio times every mode: (..., ratio, mode)."""
    return ratios[..., :, None] * sizes[..., None, :]


def outer(rows: np.ndarray) -> np.ndarray:
    """Every row by itself: (..., row, column, column)."""
    return rows[..., :, None] * rows[..., None, :]


@np.errstate(invalid="ignore", divide="ignore")
def restricted(spread: np.ndarray, left: np.ndarray, freedom: int) -> np.ndarray:
    """From the log determinants together and the squares left; the least there is where rounding
    leaves less than nothing.
    """
    found = -(spread + freedom * np.log(left / freedom)) / 2
    return np.where(left > 0, found, -np.inf)
