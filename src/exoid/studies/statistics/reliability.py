"""Test and retest: how well one occasion tells people apart, and what change is more than chance.

An occasion is a leg on a day: the mean of its drops. The standard error of measurement is what
parts two occasions of one leg of which nothing changed; 95 % of two such differ by less than the
minimal detectable change, `1.96 sqrt(2) SEM` (Weir 2005, J Strength Cond Res 19: 231-240).
"""

from collections.abc import Mapping
from dataclasses import dataclass
from math import isnan

import numpy as np
from scipy.stats import norm

from exoid.files.counted import counted
from exoid.studies.statistics.icc import icc
from exoid.studies.statistics.mixed.fit_mixed import fit_mixed
from exoid.studies.statistics.mixed.parted import Parted, stated
from exoid.studies.statistics.mixed.stacks import DROP, Effects
from exoid.studies.statistics.tables.said import Interval, NotTold
from exoid.studies.statistics.tables.values import LEG, OCCASION, Values, means
from exoid.studies.statistics.visits.standing_out import standing_out

DETECTABLE = float(norm.ppf(0.975)) * 2**0.5  # standard errors of measurement
ONLY_STATED = (
    "days and drops scatter by no more than the stated standard errors: SEM and detectable change "
    "are these alone, taken as exactly known, and have no interval"
)
BLURRED = (
    "{count} of {of} days of a leg have stated errors larger than all that legs and days differ "
    "by: ICC, SEM and detectable change are of the others"
)
ALONE = (
    "more than half of the squares by which days of a leg differ are of {who} alone, which makes "
    "SEM and detectable change larger for all: see whether those recordings are theirs, "
    "of these sides and days"
)
MOST_SESSIONS = 8  # that all may shift together; with more, sessions are dates of each person
ANOVA = "two-way analysis of variance, F intervals"
MIXED = "mixed model (REML), intervals by its information"


@dataclass(frozen=True, eq=False)
class Reliability:
    """Of the mean of `drops` drops on one day; `one_drop` and `one_drop_change` of a single one.

    `agreement` is ICC(A,1), `consistency` ICC(C,1) without the shift between sessions. `sem` and
    `change`, the minimal detectable change, hold no shift either. `variances` are what the values
    differ by, level by level. Where no day or drop is seen to scatter beyond the stated errors,
    `sem` has no interval, and `notes` say so. So they do of days that tell nothing, whose errors
    are not those of the others.
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
        who = counted(twice, "person has", "people have")
        raise NotTold(f"{who} values of two sessions or more: 3 are needed.")
    sessions = sorted(frame["session"].unique())
    mixed = fit_mixed(frame, shifts(values))
    drops = float(frame.groupby(OCCASION)["value"].size().median())
    occasions_there = len(frame[OCCASION].drop_duplicates())
    occasions = occasions_there / len(frame[LEG].drop_duplicates())
    known, blurred = stated(frame, mixed, drops)
    alone = Parted(mixed, 1.0, occasions, known)
    several = DROP in mixed.variances and drops > 1
    agreement, consistency, sem, how = of_occasions(values, Parted(mixed, drops, occasions, known))
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
        notes=(
            *([ALONE.format(who=who)] if (who := standing_out(values)) else []),
            *(notes_of(sem, blurred, occasions_there) if how == MIXED else ()),
        ),
    )


def notes_of(sem: Interval, blurred: int, occasions: int) -> tuple[str, ...]:
    """What a mixed model's answer leaves open."""
    said = [ONLY_STATED] if isnan(sem.low) else []
    return (*said, *([BLURRED.format(count=blurred, of=occasions)] if blurred else []))


def of_occasions(values: Values, parted: Parted) -> tuple[Interval, Interval, Interval, str]:
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


def scaled(each: Interval, by: float) -> Interval:
    return Interval(each.value * by, each.low * by, each.high * by)
