"""Visits whose two sides are exchanged: files, cables or legs that bear each other's names.

Each leg lasts from one visit to another. Of an exchanged visit the left leg is as the right one of
the other visits, and the right one as the left. How far visits scatter, the study itself tells, by
medians, which a few exchanged visits do not move; and that scatter has the heavy tails of t with
three degrees of freedom, so that one visit that went astray is none that is exchanged.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np
from jaxtyping import Float
from scipy.stats import norm, t

from exoid.studies.statistics.tables.frames import Column, Frame, frame_of
from exoid.studies.statistics.tables.said import NotTold
from exoid.studies.statistics.tables.study import LEADING, Study
from exoid.studies.statistics.tables.values import OCCASION, Values, means, values_of

CHANCE = 1e-3  # of a sound study, that a quantity calls a visit in it exchanged
ORDINARY = 0.01  # p, from which visits scatter like this
AGAINST = 0.01  # odds, below which a quantity speaks against an exchange
TAILS = 3.0  # degrees of freedom of t, as visits scatter
# A median of n sizes tells a standard deviation as well as 0.37 n squares do.
EFFICIENCY = 0.37
OF_MEDIAN = float(norm.ppf(0.75))  # standard deviations within which half of a normal one lies
BOTH_SIDES = ["left", "right"]
ROOT = 2**0.5

Away: TypeAlias = Float[np.ndarray, "visit 2"]
Each: TypeAlias = Float[np.ndarray, " visit"]


@dataclass(frozen=True)
class Exchanged:
    """A person's visits of which one has its sides exchanged. Of two it may be either."""

    person: str
    sessions: tuple[str, ...]


def exchanged(study: Study, task: str = "") -> tuple[Exchanged, ...]:
    """By what the motion of a leg tells of it: a visit is named where a quantity is far more likely
    of exchanged sides than of these, and none speaks against it.
    """
    asked = [verdicts(values) for values in told(study, task)]
    for_it = {visit for each in asked for visit, better in each.items() if better > 0}
    against = {visit for each in asked for visit, better in each.items() if better < 0}
    found: dict[str, list[str]] = {}
    for person, session in sorted(for_it - against):
        found.setdefault(person, []).append(session)
    return tuple(Exchanged(person, tuple(each)) for person, each in found.items())


def told(study: Study, task: str) -> Iterable[Values]:
    for quantity in LEADING:
        try:
            yield values_of(study, quantity, task)
        except NotTold:
            continue


def verdicts(values: Values) -> dict[tuple[str, str], int]:
    """Of each person and session 1 where the exchange mends it, -1 where it spoils it, else 0."""
    visits = visits_of(values)
    people = visits["person"].nunique()
    if people < 2:
        return {}
    legs, usual = sided(visits, "{}"), sided(visits, "usual_{}")
    as_told, turned = legs - usual, legs - usual[:, ::-1]
    usually = scatter_of(as_told, people)
    if usually is None:
        return {}
    odds = usually.likelihood(turned) - usually.likelihood(as_told)
    mends = usually.ordinary(turned) & (odds > np.log(len(visits) / CHANCE))
    better = mends.astype(int) - (odds < np.log(AGAINST)).astype(int)
    whose = zip(visits["person"], visits["session"], strict=True)
    return dict(zip(whose, better.tolist(), strict=True))


@dataclass(frozen=True)
class Scatter:
    """How visits of legs scatter: by what a day does to both legs, and to each by itself."""

    day: Any  # distributions of SciPy
    leg: Any

    def likelihood(self, away: Away) -> Each:
        """Its logarithm, of how far both legs are from their usual, by the likeliest of three ways:
        that the day did what one of them shows, or their mean.
        """
        of_day = (away[:, 0], away[:, 1], away.mean(axis=1))
        ways = [
            self.day.logpdf(each) + self.leg.logpdf(away - each[:, None]).sum(axis=1)
            for each in of_day
        ]
        return np.max(ways, axis=0)

    def ordinary(self, away: Away) -> np.ndarray:
        """Which visits are no farther from their usual than visits are."""
        each = (self.day.sf(np.abs(away.mean(axis=1))), self.leg.sf(np.abs(half(away)) * ROOT))
        return (2 * np.minimum(*each)) > ORDINARY


def scatter_of(away: Away, people: int) -> Scatter | None:
    """By medians, which few visits that are astray do not move; None where nothing scatters."""
    day, leg = scale(away.mean(axis=1)), ROOT * scale(half(away))
    if not (day > 0 and leg > 0):
        return None
    freedom = min(TAILS, max(EFFICIENCY * people, 1.0))
    return Scatter(t(freedom, scale=day), t(freedom, scale=leg))


def half(away: Away) -> Each:
    """Half of left less right."""
    return (away[:, 0] - away[:, 1]) / 2


def scale(away: Each) -> float:
    """The standard deviation by the median size."""
    return float(np.median(np.abs(away))) / OF_MEDIAN


def sided(visits: Frame, column: str) -> Away:
    """Of each visit what both legs have in a column, left first."""
    return visits[[column.format(side) for side in BOTH_SIDES]].to_numpy(float)


def visits_of(values: Values) -> Frame:
    """What left and right are, and what they usually are: in the person's other visits."""
    sides = means(values, OCCASION)["value"].unstack("side")
    if not {*BOTH_SIDES} <= {*sides.columns}:
        return frame_of({"person": [], "session": []})
    visits = sides[BOTH_SIDES].dropna().reset_index()
    visits = visits[visits.groupby("person")["session"].transform("size") > 1]
    usual = {f"usual_{each}": others(visits, each) for each in BOTH_SIDES}
    return visits.assign(**usual)


def others(visits: Frame, column: str) -> Column:
    """Of each visit the median of the person's other visits."""
    grouped = visits.groupby("person")[column]
    return grouped.transform(
        lambda each: [np.median(np.delete(each.to_numpy(), at)) for at in range(len(each))]
    )
