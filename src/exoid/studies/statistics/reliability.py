"""Test and retest: how well one occasion tells people apart, and what change is more than chance.

An occasion is a leg on a day: the mean of its drops. The standard error of measurement is what
parts two occasions of one leg of which nothing changed; 95 % of two such differ by less than the
minimal detectable change, `1.96 sqrt(2) SEM` (Weir 2005, J Strength Cond Res 19: 231-240).
"""

from collections.abc import Mapping
from dataclasses import dataclass
from math import isnan, nan

import numpy as np
from scipy.stats import norm

from exoid.studies.statistics.icc import icc
from exoid.studies.statistics.mixed.fit_mixed import Mixed, fit_mixed
from exoid.studies.statistics.mixed.intervals import Sum, correlation_interval, error_interval
from exoid.studies.statistics.mixed.stacks import DROP, Effects
from exoid.studies.statistics.tables.said import Interval, NotTold
from exoid.studies.statistics.tables.values import LEG, OCCASION, Values, means

DETECTABLE = float(norm.ppf(0.975)) * 2**0.5  # standard errors of measurement
STATED = 0.99  # share of the SEM's square from which on it is the stated errors alone
ONLY_STATED = (
    "days and drops scatter by no more than the stated standard errors: SEM and detectable change "
    "are these alone, taken as exactly known, and have no interval"
)
TRUE = ("person", "side")  # what lasts from one day to another
MOST_SESSIONS = 8  # that all may shift together; with more, sessions are dates of each person
ANOVA = "two-way analysis of variance, F intervals"
MIXED = "mixed model (REML), intervals by its information"


@dataclass(frozen=True, eq=False)
class Reliability:
    """Of the mean of `drops` drops on one day; `one_drop` and `one_drop_change` of a single one.

    `agreement` is ICC(A,1), `consistency` ICC(C,1) without the shift between sessions. `sem` and
    `change`, the minimal detectable change, hold no shift either. `variances` are what the values
    differ by, level by level. Where no day or drop is seen to scatter beyond the stated errors,
    `sem` has no interval, and `notes` say so.
    """

    quantity: str
    unit: str
    people: int
    legs: int
    sessions: int
    drops: float
    how: str
    agreement: Interval
    consistency: Interval
    sem: Interval
    one_drop: Interval | None
    one_drop_change: Interval | None
    variances: Mapping[str, float]
    notes: tuple[str, ...] = ()

    @property
    def change(self) -> Interval:
        return scaled(self.sem, DETECTABLE)


def reliability(values: Values) -> Reliability:
    """**Raises** `NotTold` (why) where too few people came twice, or nothing varies."""
    frame = values.frame
    often = frame.groupby("person")["session"].nunique()
    twice = int((often > 1).sum())
    if twice < 3:
        raise NotTold(f"{twice} people have values of two sessions or more: 3 are needed.")
    sessions = sorted(frame["session"].unique())
    mixed = fit_mixed(frame, shifts(values))
    drops = float(frame.groupby(OCCASION)["value"].size().median())
    occasions = len(frame[OCCASION].drop_duplicates()) / len(frame[LEG].drop_duplicates())
    alone = Parted(mixed, 1.0, occasions)
    several = DROP in mixed.variances and drops > 1
    agreement, consistency, sem, how = of_occasions(values, Parted(mixed, drops, occasions))
    return Reliability(
        quantity=values.quantity,
        unit=values.unit,
        people=values.people,
        legs=len(frame[LEG].drop_duplicates()),
        sessions=len(sessions),
        drops=drops,
        how=how,
        agreement=agreement,
        consistency=consistency,
        sem=sem,
        one_drop=alone.correlation(shift=True) if several else None,
        one_drop_change=scaled(alone.error(), DETECTABLE) if several else None,
        variances=mixed.variances,
        notes=(ONLY_STATED,) if how == MIXED and isnan(sem.low) else (),
    )


def of_occasions(values: Values, parted: "Parted") -> tuple[Interval, Interval, Interval, str]:
    """By the classical formulas where every person has one leg and came every time; else mixed."""
    table = means(values, OCCASION)["value"].unstack("session")
    alone = values.frame.groupby("person")["side"].nunique().max() == 1
    if alone and table.notna().all(axis=None):
        found = icc(table.to_numpy(float))
        return found.agreement, found.consistency, found.sem, ANOVA
    return parted.correlation(shift=True), parted.correlation(shift=False), parted.error(), MIXED


def shifts(values: Values) -> Effects:
    """The mean, and how far all are moved in each session, where people share sessions."""
    session = values.frame["session"]
    shared = values.frame.groupby("session")["person"].nunique()
    ones = np.ones((len(session), 1))
    if len(shared) > MOST_SESSIONS or (shared < 2).any():
        return ones
    others = [(session == each).to_numpy(float) for each in shared.index[1:]]
    return np.column_stack([ones, *others])


@dataclass(frozen=True, eq=False)
class Parted:
    """A mixed model's variances as those of the leg and those of an occasion of `drops` drops."""

    mixed: Mixed
    drops: float
    occasions: float  # of a leg, on average

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
        passing = np.array([1.0 / self.drops if each == DROP else 1.0 for each in levels])
        known = np.concatenate([each.known.ravel() for each in self.mixed.problem.stacks])
        return Sum(lasting), Sum(passing * (1.0 - lasting), float(known.mean()) / self.drops)


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


def scaled(each: Interval, by: float) -> Interval:
    return Interval(each.value * by, each.low * by, each.high * by)
