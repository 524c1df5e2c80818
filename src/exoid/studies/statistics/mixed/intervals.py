"""Intervals of what is made of variances, by how much all people tell of each variance.

The information is that of restricted likelihood, so in a balanced study the intervals of variances
are the classical ones: chi squared with Satterthwaite's degrees of freedom, 2 E^2 / var(E). A
correlation is taken on Fisher's scale, where its error hangs little on its size.
"""

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float
from scipy.stats import chi2, norm

from exoid.studies.statistics.mixed.fit_mixed import Mixed
from exoid.studies.statistics.mixed.likelihood import Variances, spread
from exoid.studies.statistics.tables.said import Interval

Square = Float[np.ndarray, "level level"]
TAIL = 0.025  # of either side of a 95 % interval
FEWEST = 1.0  # degrees of freedom


@dataclass(frozen=True, eq=False)
class Sum:
    """weights . variances + known, in units of the problem."""

    weights: Variances
    known: float = 0.0

    def value(self, mixed: Mixed) -> float:
        return float(self.weights @ mixed.found) + self.known


def covariance(mixed: Mixed) -> Square:
    """Of the variances: the inverse of ½ tr(P same_k P same_l), P = V^-1 - V^-1 X C X' V^-1."""
    count, middle = len(mixed.problem.levels), mixed.fitted.covariance
    alone = np.zeros((count, count))
    outer = np.zeros((count, *middle.shape))
    crossed = np.zeros((count, count))
    for stack in mixed.problem.stacks:
        inverse = np.linalg.inv(spread(mixed.found, stack))
        weighed = inverse @ stack.effects
        across = np.einsum("pvw,kpwu->kpvu", inverse, stack.same)
        alone += np.einsum("kpvw,lpwv->kl", across, across)
        shared = np.einsum("kpvw,pwe->kpve", stack.same, weighed)
        outer += np.einsum("pve,kpvf->kef", weighed, shared)
        behind = np.einsum("pvw,kpwe->kpve", inverse, shared)
        crossed += np.einsum("kpve,lpvf,ef->kl", shared, behind, middle)
    both = np.einsum("ab,kbc,cd,lda->kl", middle, outer, middle, outer)
    return np.linalg.pinv((alone - 2 * crossed + both) / 2)


def error_interval(mixed: Mixed, square: Sum) -> Interval:
    """The root of a variance, in the units of the values."""
    value, scale = square.value(mixed), mixed.problem.scale
    spread_of = float(square.weights @ covariance(mixed) @ square.weights)
    if not spread_of > 0:
        return Interval(value**0.5 * scale, float("nan"), float("nan"))
    freedom = max(2 * value**2 / spread_of, FEWEST)
    low, high = (value * freedom / float(chi2.isf(tail, freedom)) for tail in (TAIL, 1 - TAIL))
    return Interval(value**0.5 * scale, low**0.5 * scale, high**0.5 * scale)


def correlation_interval(mixed: Mixed, lasting: Sum, passing: Sum, occasions: float) -> Interval:
    """lasting / (lasting + passing), of as many occasions as a leg has on average."""
    above, below = lasting.value(mixed), passing.value(mixed)
    whole, more = above + below, occasions - 1.0
    value = above / whole
    slope = (below * lasting.weights - above * passing.weights) / whole**2
    error = max(float(slope @ covariance(mixed) @ slope), 0.0) ** 0.5
    stretched = 0.5 * np.log((1 + more * value) / (1 - value))
    half = float(norm.isf(TAIL)) * error * 0.5 * (more / (1 + more * value) + 1 / (1 - value))
    ends = (np.exp(2 * (stretched + side * half)) for side in (-1, 1))
    low, high = (float((each - 1) / (each + more)) for each in ends)
    return Interval(value, max(low, 0.0), high)
