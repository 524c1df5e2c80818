"""Visits whose two sides are exchanged: files, cables or legs that bear each other's names.

The asymmetry of a person, left less right, lasts from one visit to another. Of an exchanged visit
it has the other sign, and the mean of both sides is as ever. How far visits scatter, the study
itself tells, by medians, which a few exchanged visits do not move.
"""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from scipy.stats import norm, t

from exoid.studies.statistics.tables.frames import Column, Frame, frame_of
from exoid.studies.statistics.tables.said import NotTold
from exoid.studies.statistics.tables.study import LEADING, Study
from exoid.studies.statistics.tables.values import OCCASION, Values, means, values_of

CHANCE = 1e-3  # of a sound study, that a visit in it is said to be exchanged
ORDINARY = 0.01  # p, from which visits scatter like this
# A median of n sizes tells a standard deviation as well as 0.37 n squares do.
EFFICIENCY = 0.37
OF_MEDIAN = float(norm.ppf(0.75))  # standard deviations within which half of a normal one lies
BOTH_SIDES = ["left", "right"]


@dataclass(frozen=True)
class Exchanged:
    """A person's visits of which one has its sides exchanged. Of two it may be either."""

    person: str
    sessions: tuple[str, ...]


def exchanged(study: Study, task: str = "") -> tuple[Exchanged, ...]:
    """By what the motion of a leg tells of it: a visit is named where a quantity is as ordinary
    after the exchange as it is astray before, and none speaks against it.
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
    least = CHANCE / len(visits)
    freedom = max(EFFICIENCY * people, 1.0)
    scatter = scale(visits["apart"] - visits["usual_apart"])
    shift = rarity(visits["mean"] - visits["usual_mean"], freedom)
    as_told = rarity(visits["apart"] - visits["usual_apart"], freedom)
    turned = rarity(visits["apart"] + visits["usual_apart"], freedom, scatter)
    mends = (as_told < least) & (turned > ORDINARY) & (shift > ORDINARY)
    spoils = (turned < CHANCE) & (as_told > ORDINARY)
    better = mends.astype(int) - spoils.astype(int)
    whose = zip(visits["person"], visits["session"], strict=True)
    return dict(zip(whose, better.tolist(), strict=True))


def visits_of(values: Values) -> Frame:
    """Left less right and their mean, with the usual ones of the person's other visits."""
    sides = means(values, OCCASION)["value"].unstack("side")
    if not {*BOTH_SIDES} <= {*sides.columns}:
        return frame_of({"person": [], "session": []})
    both = sides[BOTH_SIDES].dropna().reset_index()
    visits = frame_of(
        {
            "person": both["person"],
            "session": both["session"],
            "apart": both["left"] - both["right"],
            "mean": (both["left"] + both["right"]) / 2,
        }
    )
    visits = visits[visits.groupby("person")["session"].transform("size") > 1]
    usual = {f"usual_{each}": others(visits, each) for each in ("apart", "mean")}
    return visits.assign(**usual)


def others(visits: Frame, column: str) -> Column:
    """Of each visit the median of the person's other visits."""
    grouped = visits.groupby("person")[column]
    return grouped.transform(
        lambda each: [np.median(np.delete(each.to_numpy(), at)) for at in range(len(each))]
    )


def scale(residual: Column) -> float:
    """The standard deviation by the median size, which few that are astray do not move."""
    return float(residual.abs().median()) / OF_MEDIAN


def rarity(residual: Column, freedom: float, scatter: float | None = None) -> Column:
    """p of a size like this by chance, where the scatter is that of the residuals."""
    scatter = scale(residual) if scatter is None else scatter
    if not scatter > 0:
        return residual * 0 + 1.0
    return residual.abs().map(lambda each: float(2 * t.sf(each / scatter, freedom)))
