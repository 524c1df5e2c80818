"""What is in the residual of a fit: the sensors' white noise, and what the model misses.

A torque that the model lacks moves the leg along with what its parameters do, so most of its
effect hides in the parameters and little is left in the residual: neither its size nor its
autocorrelation can tell how wrong they are. Here the missing torque, or a slow error of the
encoder, is a Gaussian process u(t) with a Matern covariance; its size and correlation time are
those of greatest restricted likelihood (Patterson & Thompson, Biometrika 58(3), 1971), which allows
for what the parameters absorbed.
"""

from functools import cache
from itertools import product

import numpy as np

from exoid.fitting.misfit.gram import CAUSES, UNIT, Cause, Gram, Grams
from exoid.fitting.misfit.gram_matrices import modes
from exoid.fitting.misfit.missed import Missed
from exoid.fitting.misfit.uncertainty import whitening

CORRELATED = (0.025, 0.05, 0.1, 0.2, 0.4, 0.8)  # s
SIZES = np.logspace(-7, 4, 12)  # of u's variance over that of the noise, in units of the gram
FINER = np.logspace(-0.8, 0.8, 9)  # a fifth of a decade apart
LEAST = 1e-15  # share of what tells a direction that a process leaves: below is rounding
# Of the gain that a process must have, from which on a decade's grid looks closer: it shows half of
# what lies between its points, for however few or many nodes.
PROMISING = 0.25
CLEAR = 4.0  # gain of log likelihood below which the noise alone explains the residual


def explain(grams: list[Grams], most: dict[Cause, float], samples: int, size: int) -> Missed:
    """The noise and the process of greatest restricted likelihood.

    The unknowns of the segments are among `size` coordinates. `most` bounds the deviation: what
    nearly hides in the parameters may else grow without limit.
    """

    @cache
    def likelihood(cause: Cause, correlated: float) -> Likelihood:
        return Likelihood([each[cause] for each in grams], correlated, samples, size)

    found: tuple[Cause | None, float, float] = (None, CORRELATED[0], 0.0)
    plain = likelihood("torque", CORRELATED[0])(np.zeros(1))[0]
    best = plain + CLEAR
    for cause, correlated in product(CAUSES, CORRELATED):
        bound, enough = (most[cause] / UNIT[cause]) ** 2, plain + PROMISING * (best - plain)
        ratio, value = likelihood(cause, correlated).greatest(bound, enough)
        if value > best:
            best = value
            found = (cause, correlated, ratio)
    cause, correlated, ratio = found
    noise = likelihood(cause or "torque", correlated).noise_beside(ratio)
    return Missed(*found, noise, float(best))


class Likelihood:
    """The restricted log likelihood of a process' size, with the noise at its best.

    What the data determine at all is decided once, without the process: that it hides a direction
    does not make it one that nothing tells.
    """

    def __init__(self, grams: list[Gram], correlated: float, samples: int, size: int):
        self.parts = [(each, *modes(each, correlated)) for each in grams]
        self.size = size
        plain = self.total(np.zeros(1))[0, :size, :size]
        basis, unit = whitening(plain)
        self.basis = basis / unit[:, None]
        self.freedom = samples - basis.shape[1]

    def greatest(self, most: float, enough: float = -np.inf) -> tuple[float, float]:
        """The variance ratio up to `most` where it is greatest, and its value there: to a decade, and
        where that is `enough` to a fifth of one.
        """
        coarse = np.append(SIZES[most > SIZES], most)
        values = self(coarse)
        top = int(np.argmax(values))
        if values[top] < enough:
            return float(coarse[top]), float(values[top])
        near = np.minimum(coarse[top] * FINER, most)
        values = self(near)
        top = int(np.argmax(values))
        return float(near[top]), float(values[top])

    def __call__(self, ratios: np.ndarray) -> np.ndarray:
        grown = [np.log1p(ratios[:, None] * sizes).sum(axis=1) for _, sizes, _ in self.parts]
        absorbed, left = self.profiled(ratios)
        return restricted(sum(grown) + absorbed, left, self.freedom)

    def profiled(self, ratios: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The log determinant of A'V^-1 A over that of A'A, and the least r'V^-1 r that the
        parameters leave, for each ratio; V is the covariance over the noise.
        """
        total, size = self.total(ratios), self.size
        values, axes = np.linalg.eigh(self.basis.T @ total[:, :size, :size] @ self.basis)
        values = np.maximum(values, LEAST)
        along = np.einsum("rij,ri->rj", axes, total[:, :size, size] @ self.basis)
        left = total[:, size, size] - np.sum(along**2 / values, axis=1)
        return np.log(values).sum(axis=1), left

    def total(self, ratios: np.ndarray) -> np.ndarray:
        """(A, r)'V^-1 (A, r) for each ratio."""
        total = np.zeros((ratios.size, self.size + 1, self.size + 1))
        for each, sizes, inside in self.parts:
            share = 1 / (1 + ratios[:, None] * sizes)
            place = np.append(each.place, self.size)
            total[:, place[:, None], place] += each.outside.T @ each.outside
            total[:, place[:, None], place] += inside.T @ (share[:, :, None] * inside)
        return total

    def noise_beside(self, ratio: float) -> float:
        """The white noise over the declared one; sensors are no better than declared."""
        left = self.profiled(np.array([ratio]))[1][0]
        return float(np.sqrt(max(1.0, left / self.freedom)))


@np.errstate(invalid="ignore", divide="ignore")
def restricted(spread: np.ndarray, left: np.ndarray, freedom: int) -> np.ndarray:
    """From the log determinants together and the squares left; the least there is where rounding
    leaves less than nothing.
    """
    found = -(spread + freedom * np.log(left / freedom)) / 2
    return np.where(left > 0, found, -np.inf)
