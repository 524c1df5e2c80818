"""How far groups are apart, in standard deviations of people."""

import numpy as np
from scipy.special import gammaln
from scipy.stats import norm, t

from exoid.studies.statistics.agreement import around
from exoid.studies.statistics.tables.frames import Column
from exoid.studies.statistics.tables.said import Interval


def hedges(effect: Interval, of_effect: int, first: Column, second: Column) -> Interval:
    """A difference of two groups, with the freedom of its interval, over the standard deviation of
    the means of people (Hedges 1981). The plain difference of these means may have another sign: it
    weighs people who are badly known like others.
    """
    m, n = len(first), len(second)
    freedom = m + n - 2
    pooled = ((m - 1) * first.var() + (n - 1) * second.var()) / freedom
    if not pooled > 0:
        return around(float("nan"), float("nan"))
    small = float(np.exp(gammaln(freedom / 2) - gammaln((freedom - 1) / 2))) * (2 / freedom) ** 0.5
    g = small * effect.value / float(pooled) ** 0.5
    error = (effect.high - effect.low) / (2 * float(t.ppf(0.975, of_effect)))
    variance = error**2 / float(pooled) + g**2 / (2 * (m + n))
    return around(g, float(norm.ppf(0.975)) * variance**0.5)
