"""A Gaussian process beside white noise, for any ratio of their variances at little cost.

With an orthogonal Q that makes the covariance P of the process tridiagonal, T = Q'P Q, a whole
I + ratio P is Q (I + ratio T) Q': found once, every ratio takes n steps (Golub & Van Loan, Matrix
Computations, 8.3 and 4.3).
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.linalg import get_lapack_funcs

LEAST = 1e-14  # of a process, that white noise is at least: below is rounding
# What SciPy checks around these takes longer than they do.
REDUCE, ROTATE = get_lapack_funcs(("sytrd", "ormqr"))
BLOCK = 32  # columns that the rotation takes at once


@dataclass(frozen=True, eq=False)
class Tridiagonal:
    """Of the processes of several segments T = Q'P Q, and rows of the same columns along each Q."""

    diagonal: np.ndarray  # (node, segment, ...process)
    beside: np.ndarray  # (node less one, segment, ...process)
    rows: np.ndarray  # Q' rows, (node, segment, ...process, column)

    def beside_noise(self, ratios: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """log |V| and rows'V^-1 rows of V = I + ratio P, of every segment, for each
        ratio: of (ratio) or (...process, ratio) the first is (segment, ...process, ratio).
        """
        noise = np.maximum(1.0, LEAST * ratios * self.diagonal.sum(axis=0)[..., None])
        pivots = noise + ratios * self.diagonal[..., None]
        beside = ratios * self.beside[..., None]
        rows = np.empty((*pivots.shape, self.rows.shape[-1]))
        rows[0] = self.rows[0, ..., None, :]
        for at, each in enumerate(beside):
            factor = each / pivots[at]
            pivots[at + 1] -= factor * each
            rows[at + 1] = self.rows[at + 1, ..., None, :] - factor[..., None] * rows[at]
        every = np.moveaxis(rows / np.sqrt(pivots)[..., None], 0, -2)
        return np.log(pivots).sum(axis=0), np.swapaxes(every, -1, -2) @ every


def tridiagonal(processes: Sequence[np.ndarray], rows: Sequence[np.ndarray]) -> Tridiagonal:
    """Of every segment covariances (...process, node, node), and rows (node, column)."""
    whole, (nodes, columns) = np.stack(processes), rows[0].shape
    diagonal = np.empty((nodes, *whole.shape[:-2]))
    beside = np.empty((nodes - 1, *diagonal.shape[1:]))
    along = np.empty((*diagonal.shape, columns))
    for at in np.ndindex(diagonal.shape[1:]):
        own, each = rows[at[0]], (slice(None), *at)
        reflected, diagonal[each], beside[each], factors, _ = REDUCE(whole[at], lower=1)
        turned = ROTATE("L", "T", reflected[1:, :-1], factors, own[1:], columns * BLOCK)[0]
        along[each] = np.vstack([own[:1], turned])
    return Tridiagonal(diagonal, beside, along)
