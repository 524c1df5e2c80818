"""The restricted likelihood of a disturbance beside the noise (Patterson & Thompson, 1971)."""

import numpy as np

from exoid.fitting.misfit.disturbance.tridiagonal import tridiagonal
from exoid.fitting.misfit.gram import Gram
from exoid.fitting.misfit.gram_matrices import Times, covariance
from exoid.fitting.misfit.uncertainty import whitening

SIZES = np.logspace(-7, 4, 12)  # of u's variance over that of the noise, in units of the gram
FINER = np.logspace(-0.8, 0.8, 9)  # a fifth of a decade apart


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
        disturbed = [each for each in grams if each.nodes.size > 1]  # else nothing disturbs it
        self.processes = tridiagonal(
            [each.effect @ covariance(each, correlated) @ each.effect.T for each in disturbed],
            [self.told(each, each.inside) for each in disturbed],
        )

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
        spread, inside = self.processes.beside_noise(ratios)
        total = self.outside + inside.sum(axis=0)  # (A, r)'V^-1 (A, r) along what is determined
        known, along = total[..., :-1, :-1], total[..., :-1, -1]
        sign, extent = np.linalg.slogdet(known)
        lost = sign <= 0  # a direction that so large a process hides but for rounding
        known = np.where(lost[..., None, None], np.eye(known.shape[-1]), known)
        best = np.linalg.solve(known, along[..., None])[..., 0]
        left = total[..., -1, -1] - np.sum(along * best, axis=-1)
        return np.where(lost, np.inf, spread.sum(axis=0) + extent), left

    def noise_beside(self, ratio: float) -> np.ndarray:
        """The white noise over the declared one; sensors are no better than declared."""
        left = self.profiled(np.array([ratio]))[1][..., 0]
        return np.sqrt(np.maximum(1.0, left / self.freedom))


@np.errstate(invalid="ignore", divide="ignore")
def restricted(spread: np.ndarray, left: np.ndarray, freedom: int) -> np.ndarray:
    """From the log determinants together and the squares left; the least there is where rounding
    leaves less than nothing, or hides a direction.
    """
    found = -(spread + freedom * np.log(left / freedom)) / 2
    return np.where(left > 0, found, -np.inf)
