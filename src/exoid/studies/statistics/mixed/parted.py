"""A mixed model's variances as what lasts from one day to another, and what does not."""

from dataclasses import dataclass
from math import nan

import numpy as np

from exoid.studies.statistics.mixed.fit_mixed import Mixed
from exoid.studies.statistics.mixed.intervals import Sum, correlation_interval, error_interval
from exoid.studies.statistics.mixed.likelihood import Variances
from exoid.studies.statistics.mixed.stacks import DROP
from exoid.studies.statistics.tables.frames import Frame
from exoid.studies.statistics.tables.said import Interval
from exoid.studies.statistics.tables.values import OCCASION

STATED = 0.99  # share of the SEM's square from which on it is the stated errors alone
UNUSUAL = 2.0  # times the median error
TRUE = ("person", "side")  # what lasts from one day to another


def stated(frame: Frame, mixed: Mixed, drops: float) -> tuple[float, int]:
    """The mean variance of the values' own errors, in units of the problem, and how many occasions
    do not count in it: those whose errors are larger than all that exact ones differ by, and than
    `UNUSUAL` times those of half of all. They weigh little in the model, and would be all of the
    mean.
    """
    rows = np.concatenate([each.rows.ravel() for each in mixed.problem.stacks])
    known = np.concatenate([each.known.ravel() for each in mixed.problem.stacks])
    of = frame.iloc[rows].groupby(OCCASION).ngroup().to_numpy()
    mean = np.bincount(of, known) / np.bincount(of) ** 2
    exact = float(shares(mixed, drops) @ mixed.found)
    blurred = mean > max(exact, UNUSUAL**2 * float(np.median(mean)))
    return float(known[~blurred[of]].mean()), int(blurred.sum())


def shares(mixed: Mixed, drops: float) -> Variances:
    """Of each level's variance, what the mean of so many drops has."""
    return np.array([1.0 / drops if each == DROP else 1.0 for each in mixed.problem.levels])


@dataclass(frozen=True, eq=False)
class Parted:
    """A mixed model's variances as those of the leg and those of an occasion of `drops` drops."""

    mixed: Mixed
    drops: float
    occasions: float  # of a leg, on average
    known: float  # variance of the error of one value, in units of the problem

    def correlation(self, *, shift: bool) -> Interval:
        """The share of what lasts; a shift between sessions is taken as it was found."""
        lasting, passing = self.parts()
        moved = shift_of(self.mixed) if shift else 0.0
        return correlation_interval(
            self.mixed, lasting, Sum(passing.weights, passing.known + moved), self.occasions
        )

    def error(self) -> Interval:
        """The standard error of measurement. Variances at their limit of zero leave what was
        stated, of which no value tells how true it is.
        """
        passing = self.parts()[1]
        found = error_interval(self.mixed, passing)
        if passing.known < STATED * passing.value(self.mixed):
            return found
        return Interval(found.value, nan, nan)

    def parts(self) -> tuple[Sum, Sum]:
        """What lasts from one day to another, and what does not."""
        levels = self.mixed.problem.levels
        lasting = np.array([float(each in TRUE) for each in levels])
        passing = shares(self.mixed, self.drops) * (1.0 - lasting)
        return Sum(lasting), Sum(passing, self.known / self.drops)


def shift_of(mixed: Mixed) -> float:
    """The variance of the sessions' means, less what it is by chance, in units of the problem."""
    effects = np.concatenate([[0.0], mixed.fitted.effects[1:]])
    count = effects.size
    if count < 2:
        return 0.0
    covariance = np.zeros((count, count))
    covariance[1:, 1:] = mixed.fitted.covariance[1:, 1:]
    centred = np.eye(count) - 1.0 / count
    by_chance = float(np.trace(centred @ covariance)) / (count - 1)
    return max(float(effects.var(ddof=1)) - by_chance, 0.0)
