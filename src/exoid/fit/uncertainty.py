"""Standard errors, and whether the data, the prior or a bound determined a value."""

from typing import Literal

import numpy as np
from jaxtyping import Float

Source = Literal["data", "prior", "both", "bound"]

UNDETERMINED = 1e-3  # information per typical step squared: an error of thirty typical steps
ON_BOUND = 1e-4  # relative size of what is left of a gradient where an end point lies on a limit
FROM_DATA = 0.9  # share of the precision above which the data alone determined a value
FROM_PRIOR = 0.5  # of its prior's standard deviation, above which the data hardly narrowed it


class Information:
    """Gauss-Newton information of a fit in its own coordinates, around the end point.

    `data` and `prior` are (coordinate, coordinate); `active` holds the gradients of the constraints
    that hold as equalities there, (constraint, coordinate).
    """

    def __init__(self, data: np.ndarray, prior: np.ndarray, active: np.ndarray):
        self.free = null_space(active, data.shape[0])
        self.posterior = np.linalg.eigh(self.free.T @ (data + prior) @ self.free)
        self.likelihood = np.linalg.eigh(self.free.T @ data @ self.free)
        self.unbounded = np.linalg.eigh(data)

    def standard_error(self, gradient: Float[np.ndarray, " coordinate"]) -> float:
        """Of a quantity with this gradient; inf where nothing determines it, 0 on a bound."""
        return spread(self.posterior, self.free, gradient)

    def data_only(self, gradient: Float[np.ndarray, " coordinate"]) -> float:
        """The standard error without any prior; inf where motion cannot tell."""
        return spread(self.likelihood, self.free, gradient)

    def needs_bound(self, gradient: Float[np.ndarray, " coordinate"]) -> bool:
        """Is it a bound that lets the data tell this?"""
        everything = np.eye(gradient.size)
        alone = np.isfinite(spread(self.unbounded, everything, gradient))
        return bool(np.isfinite(self.data_only(gradient)) and not alone)


def spread(decomposed, free, gradient) -> float:
    """sqrt(a' I^-1 a) within the `free` directions, from the eigenvalues and vectors of I there."""
    along = free.T @ gradient
    size = np.linalg.norm(along)
    if size <= ON_BOUND * np.linalg.norm(gradient):
        return 0.0
    values, vectors = decomposed
    parts = vectors.T @ along
    known = values > UNDETERMINED
    if np.linalg.norm(parts[~known]) > ON_BOUND * size:
        return np.inf
    return float(np.sqrt(np.sum(parts[known] ** 2 / values[known])))


def null_space(rows, size: int):
    """An orthonormal basis of the directions that leave every row's value unchanged."""
    if rows.shape[0] == 0:
        return np.eye(size)
    _, values, vectors = np.linalg.svd(rows)
    rank = int(np.sum(values > 1e-9 * values[0]))
    return vectors[rank:].T


def source(
    information: Information, gradient, prior_deviation: float, at_bound: bool
) -> Source | None:
    """Who determined a value; None where nothing did."""
    error = information.standard_error(gradient)
    if at_bound or error == 0.0:
        return "bound"
    if not np.isfinite(error):
        return None
    if information.needs_bound(gradient):
        return "bound"
    alone = information.data_only(gradient)
    if np.isfinite(alone) and error**2 >= FROM_DATA * alone**2:
        return "data"
    return "prior" if error >= FROM_PRIOR * prior_deviation else "both"


def noise_scale(residuals: list[np.ndarray], unknowns: int) -> float:
    """How much larger than the noise the residual is, as it counts for standard errors.

    1 where the model explains the data. Where it does not, chi per degree of freedom times the
    square root of the residual's correlation time: neighbouring errors are not new evidence.
    """
    total = sum(float(each @ each) for each in residuals)
    count = sum(each.size for each in residuals)
    ratio = total / max(count - unknowns, 1)
    if ratio < 1.2:  # white noise of a few hundred samples stays below this
        return max(1.0, float(np.sqrt(ratio)))
    times = [correlation_time(each) for each in residuals if each.size > 20]
    return float(np.sqrt(ratio * max(1.0, np.mean(times)))) if times else float(np.sqrt(ratio))


def correlation_time(residual: Float[np.ndarray, " sample"]) -> float:
    """1 + 2 sum of the autocorrelation up to its first value below 0.05 [samples]."""
    centred = residual - residual.mean()
    spectrum = np.abs(np.fft.rfft(centred, 2 * centred.size)) ** 2
    correlation = np.fft.irfft(spectrum)[: centred.size]
    correlation = correlation / correlation[0]
    below = np.flatnonzero(correlation < 0.05)
    end = below[0] if below.size else correlation.size
    return float(1 + 2 * correlation[1:end].sum())
