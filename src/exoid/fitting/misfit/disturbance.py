"""What is in the residual of a fit: the sensors' white noise, and what the model misses.

A torque that the model lacks moves the leg along with what its parameters do, so most of its
effect hides in the parameters and little is left in the residual: neither its size nor its
autocorrelation can tell how wrong they are. Here the missing torque, or a slow error of the
encoder, is a Gaussian process u(t) with a Matern covariance; its size and correlation time are
those of greatest restricted likelihood (Patterson & Thompson, Biometrika 58(3), 1971), which allows
for what the parameters absorbed.
"""

from itertools import product

import numpy as np

from exoid.fitting.misfit.gram import CAUSES, UNIT, Cause, Gram, Grams
from exoid.fitting.misfit.gram_matrices import modes
from exoid.fitting.misfit.missed import Missed
from exoid.fitting.misfit.uncertainty import ROUNDING, whitening

CORRELATED = (0.025, 0.05, 0.1, 0.2, 0.4, 0.8)  # s
SIZES = np.logspace(-7, 4, 12)  # of u's variance over that of the noise, in units of the gram
FINER = np.logspace(-0.8, 0.8, 9)  # a fifth of a decade apart
CLEAR = 4.0  # gain of log likelihood below which the noise alone explains the residual


def explain(grams: list[Grams], most: dict[Cause, float], samples: int, size: int) -> Missed:
    """The noise and the process of greatest restricted likelihood.

    The unknowns of the segments are among `size` coordinates. `most` bounds the deviation: what
    nearly hides in the parameters may else grow without limit.
    """

    def likelihood(cause: Cause, correlated: float) -> Likelihood:
        return Likelihood([each[cause] for each in grams], correlated, samples, size)

    found: tuple[Cause | None, float, float] = (None, CORRELATED[0], 0.0)
    best = likelihood("torque", CORRELATED[0])(np.zeros(1))[0] + CLEAR
    for cause, correlated in product(CAUSES, CORRELATED):
        ratio, value = likelihood(cause, correlated).greatest((most[cause] / UNIT[cause]) ** 2)
        if value > best:
            best = value
            found = (cause, correlated, ratio)
    cause, correlated, ratio = found
    noise = likelihood(cause or "torque", correlated).noise_beside(ratio)
    return Missed(*found, noise, float(best))


class Likelihood:
    """The restricted log likelihood of a process' size, with the noise at its best."""

    def __init__(self, grams: list[Gram], correlated: float, samples: int, size: int):
        self.parts = [(each, *modes(each, correlated)) for each in grams]
        self.samples, self.size = samples, size

    def greatest(self, most: float) -> tuple[float, float]:
        """The variance ratio up to `most` where it is greatest, and its value there."""
        coarse = np.append(SIZES[most > SIZES], most)
        near = np.minimum(coarse[int(np.argmax(self(coarse)))] * FINER, most)
        values = self(near)
        top = int(np.argmax(values))
        return float(near[top]), float(values[top])

    def __call__(self, ratios: np.ndarray) -> np.ndarray:
        return restricted(*self.weighted(ratios), self.samples)

    def weighted(self, ratios: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The weighted (A, r)'(A, r), and the log determinant of the covariance, for each ratio."""
        size = self.size
        total = np.zeros((ratios.size, size + 1, size + 1))
        spread = np.zeros(ratios.size)
        for each, sizes, cross in self.parts:
            grown = 1 + ratios[:, None] * sizes
            share = ratios[:, None] / grown
            taken = cross.T @ (share[:, :, None] * cross)
            place = np.append(each.place, size)
            total[:, place[:, None], place] += each.fitted - taken
            spread += np.log(grown).sum(axis=1)
        return total, spread

    def noise_beside(self, ratio: float) -> float:
        """The white noise over the declared one; sensors are no better than declared."""
        total, size = self.weighted(np.array([ratio]))[0][0], self.size
        basis, unit = whitening(total[:size, :size])
        along = (total[:size, size] / unit) @ basis
        left = total[size, size] - along @ along
        return float(np.sqrt(max(1.0, left / (self.samples - basis.shape[1]))))


@np.errstate(invalid="ignore", divide="ignore")
def restricted(total: np.ndarray, spread: np.ndarray, samples: int) -> np.ndarray:
    """From the weighted (A, r)'(A, r) and the log determinant of the covariance, for each row; the
    least there is where rounding leaves less than nothing.
    """
    size = total.shape[1] - 1
    unit = np.sqrt(np.diagonal(total[:, :size, :size], axis1=1, axis2=2))
    used = (unit > 0).all(axis=0)
    unit = unit[:, used]
    normal = total[:, :size, :size][:, used][:, :, used] / (unit[:, :, None] * unit[:, None, :])
    values, vectors = np.linalg.eigh(normal)
    known = values > ROUNDING
    values = np.where(known, values, 1.0)
    along = np.einsum("rij,ri->rj", vectors, total[:, :size, size][:, used] / unit)
    left = total[:, size, size] - np.sum(known * along**2 / values, axis=1)
    freedom = samples - known.sum(axis=1)
    absorbed = np.log(values).sum(axis=1) + 2 * np.log(unit).sum(axis=1)
    found = -(spread + absorbed + freedom * np.log(left / freedom)) / 2
    return np.where(np.isnan(found), -np.inf, found)
