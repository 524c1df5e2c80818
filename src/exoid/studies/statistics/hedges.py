"""How far groups are apart, in standard deviations of people."""

import numpy as np
from scipy.special import gammaln
from scipy.stats import norm

from exoid.studies.statistics.agreement import around
from exoid.studies.statistics.tables.frames import Column
from exoid.studies.statistics.tables.said import Interval


def hedges(first: Column, second: Column) -> Interval:
    """The difference of the means of people over their standard deviation (Hedges 1981)."""
    m, n = len(first), len(second)
    freedom = m + n - 2
    pooled = ((m - 1) * first.var() + (n - 1) * second.var()) / freedom
    if not pooled > 0:
        return around(float("nan"), float("nan"))
    small = float(np.exp(gammaln(freedom / 2) - gammaln((freedom - 1) / 2))) * (2 / freedom) ** 0.5
    g = small * float(second.mean() - first.mean()) / float(pooled) ** 0.5
    variance = (m + n) / (m * n) + g**2 / (2 * (m + n))
    return around(g, float(norm.ppf(0.975)) * variance**0.5)
