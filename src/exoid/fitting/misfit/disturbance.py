"""What is in the residual of a fit: the sensors' white noise, and what the model misses.

A torque that the model lacks moves the leg along with what its parameters do, so most of its
effect hides in the parameters and little is left in the residual: neither its size nor its
autocorrelation can tell how wrong they are. Here the missing torque, or a slow error of the
encoder, is a Gaussian process u(t) with a Matern covariance; its size and correlation time are
those of greatest restricted likelihood (Patterson & Thompson, Biometrika 58(3), 1971), which allows
for what the parameters absorbed.
"""

import numpy as np
from scipy.linalg import get_lapack_funcs

from exoid.fitting.misfit.gram import CAUSES, UNIT, Cause, Gram, Grams
from exoid.fitting.misfit.gram_matrices import Times, covariance
from exoid.fitting.misfit.missed import Missed
from exoid.fitting.misfit.uncertainty import whitening

CORRELATED = (0.025, 0.05, 0.1, 0.2, 0.4, 0.8)  # s
SIZES = np.logspace(-7, 4, 12)  # of u's variance over that of the noise, in units of the gram
FINER = np.logspace(-0.8, 0.8, 9)  # a fifth of a decade apart
LEAST = 1e-14  # of a process, that white noise is at least: below is rounding
CLEAR = 4.0  # gain of log likelihood below which the noise alone explains the residual
# Gain at a decade's grid from which on it is worth to look closer: that shows about half of what is
# between its points, for however few or many nodes.
PROMISING = CLEAR / 4
(SOLVE,) = get_lapack_funcs(("trtrs",))  # what SciPy checks around it takes longer than it does


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
        rows = np.concatenate([self.told(each, each.outside) for each in grams])
        self.outside = rows.T @ rows
        self.parts = [
            (
                each.effect @ covariance(each, correlated) @ each.effect.T,
                self.told(each, each.inside),
            )
            for each in grams
            if each.nodes.size > 1  # else nothing disturbs it
        ]

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
        spread, left = self.profiled(np.atleast_1d(ratios))
        return restricted(spread, left, self.freedom)

    def profiled(self, ratios: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The log determinants of V, the covariance over the noise, and of A'V^-1 A over that of
        A'A, together; and the least r'V^-1 r that the parameters leave, for each ratio.
        """
        spread, total = np.zeros(1), self.outside  # (A, r)'V^-1 (A, r) along what is determined
        for process, inside in self.parts:
            covariances = ratios[..., None, None] * process[..., None, :, :]
            grown = LEAST * np.trace(covariances, axis1=-2, axis2=-1)
            at = np.arange(len(inside))
            covariances[..., at, at] += np.maximum(1.0, grown)[..., None]
            roots = np.linalg.cholesky(covariances)
            spread = spread + 2 * np.log(np.diagonal(roots, axis1=-2, axis2=-1)).sum(axis=-1)
            rows = solved(roots, inside)
            total = total + np.swapaxes(rows, -1, -2) @ rows
        known, along = total[..., :-1, :-1], total[..., :-1, -1]
        best = np.linalg.solve(known, along[..., None])[..., 0]
        left = total[..., -1, -1] - np.sum(along * best, axis=-1)
        return spread + np.linalg.slogdet(known)[1], left

    def noise_beside(self, ratio: float) -> np.ndarray:
        """The white noise over the declared one; sensors are no better than declared."""
        left = self.profiled(np.array([ratio]))[1][..., 0]
        return np.sqrt(np.maximum(1.0, left / self.freedom))


def solved(roots: np.ndarray, rows: np.ndarray) -> np.ndarray:
    """L^-1 of the same rows, for each lower triangle L."""
    each = roots.reshape(-1, *roots.shape[-2:])
    found = np.stack([SOLVE(root.T, rows, trans=1)[0] for root in each])
    return found.reshape(*roots.shape[:-2], *rows.shape)


@np.errstate(invalid="ignore", divide="ignore")
def restricted(spread: np.ndarray, left: np.ndarray, freedom: int) -> np.ndarray:
    """From the log determinants together and the squares left; the least there is where rounding
    leaves less than nothing.
    """
    found = -(spread + freedom * np.log(left / freedom)) / 2
    return np.where(left > 0, found, -np.inf)
