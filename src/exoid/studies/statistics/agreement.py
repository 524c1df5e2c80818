"""How far two values of a person are apart: differences and limits of agreement.

Bland & Altman (1986), Lancet 327: 307-310, and (1999), Stat Methods Med Res 8: 135-160.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.stats import linregress, norm, t

from exoid.studies.statistics.mixed.fit_mixed import fit_mixed
from exoid.studies.statistics.pairs import Pairs
from exoid.studies.statistics.tables.frames import frame_of
from exoid.studies.statistics.tables.said import Interval, NotTold

WITHIN = float(norm.ppf(0.975))  # standard deviations that hold 95 % of a normal distribution


@dataclass(frozen=True, eq=False)
class Agreement:
    """Second less first.

    `bias` is the mean of the differences, `lower` and `upper` are the limits between which 95 % of
    them lie, each with its own interval. `difference` is the mean again, in which people of whom
    estimates tell more weigh more; `p` is of it. `slope` is that of the difference over the mean:
    a bias that grows with the size. `by_error` is the share of the differences' variance that the
    errors of the estimates explain, None where these are unknown.
    """

    pairs: Pairs
    bias: Interval
    deviation: float
    lower: Interval
    upper: Interval
    difference: Interval
    p: float
    slope: Interval
    slope_p: float
    by_error: float | None

    @property
    def people(self) -> int:
        return len(self.pairs.frame)


def agreement(pairs: Pairs) -> Agreement:
    """**Raises** `NotTold` (why) where all differ by the same."""
    apart = pairs.difference.to_numpy(float)
    size = np.abs(pairs.frame[["first", "second"]].to_numpy(float)).max()
    n, bias, deviation = apart.size, float(apart.mean()), float(apart.std(ddof=1))
    if not deviation > 8 * np.finfo(float).eps * size:
        raise NotTold(
            f"{pairs.first!r} and {pairs.second!r} differ by the same in all {n} people, which no "
            "measurement does."
        )
    more = float(t.ppf(0.975, n - 1))
    limit = more * deviation * (1 / n + WITHIN**2 / (2 * (n - 1))) ** 0.5
    lower, upper = (bias + sign * WITHIN * deviation for sign in (-1, 1))
    difference, p = carried(pairs)
    slope, slope_p = proportional(pairs)
    error = pairs.error.to_numpy(float)
    told = bool(np.isfinite(error).all())
    return Agreement(
        pairs=pairs,
        bias=around(bias, more * deviation / n**0.5),
        deviation=deviation,
        lower=around(lower, limit),
        upper=around(upper, limit),
        difference=difference,
        p=p,
        by_error=min(float(np.mean(error**2)) / deviation**2, 1.0) if told else None,
        slope=slope,
        slope_p=slope_p,
    )


def carried(pairs: Pairs) -> tuple[Interval, float]:
    """The mean difference and its p, by a model in which each difference has its own error."""
    frame = frame_of(
        {
            "person": pairs.frame.index.to_numpy(str),
            "side": "",
            "session": "",
            "value": pairs.difference.to_numpy(float),
            "error": pairs.error.to_numpy(float),
        }
    )
    mixed = fit_mixed(frame, np.ones((len(frame), 1)))
    return wald(float(mixed.effects[0]), float(mixed.covariance[0, 0]) ** 0.5, len(frame) - 1)


def wald(value: float, error: float, freedom: int) -> tuple[Interval, float]:
    """An effect with its 95 % interval and its p, by Student's t."""
    found = around(value, float(t.ppf(0.975, freedom)) * error)
    return found, float(2 * t.sf(abs(value) / error, freedom))


def proportional(pairs: Pairs) -> tuple[Interval, float]:
    """The slope of the differences over the means, and its p."""
    mean = pairs.mean.to_numpy(float)
    if mean.size < 4 or not np.ptp(mean) > 0:
        return around(float("nan"), float("nan")), float("nan")
    line: Any = linregress(mean, pairs.difference.to_numpy(float))
    half = float(t.ppf(0.975, mean.size - 2)) * float(line.stderr)
    return around(float(line.slope), half), float(line.pvalue)


def around(value: float, half: float) -> Interval:
    return Interval(value, value - half, value + half)
