"""Every leg of every person as a point, in the groups that are compared."""

from collections.abc import Sequence
from math import isfinite

import numpy as np

from exoid.files.counted import counted
from exoid.report.pictures.axis import view
from exoid.report.pictures.panel import Axis, Mark, Panel, Picture, Points
from exoid.report.pictures.role import Role
from exoid.report.words.text import capital, quantity_words, shown_unit
from exoid.studies.page.parts.numbers import number, with_interval
from exoid.studies.statistics.asked import Answer, Asked
from exoid.studies.statistics.groups import MOST_GROUPS, Comparison, label
from exoid.studies.statistics.tables.frames import Frame
from exoid.studies.statistics.tables.values import Values, means

SIDES = {"left": Role.LEFT, "right": Role.RIGHT}
GOLDEN = 0.618034  # steps by it fill a width evenly
BREADTH = 0.34  # of the place of a group, on either side
HEIGHT = 4.6  # size of the panel
EVERYONE = "all people"


def people(answer: Answer, asked: Asked) -> Picture:
    """Every leg of every person by the mean of its drops, in the groups that are `asked` for; where
    something was to change, as it was before.
    """
    before, values = asked.before, shown(answer, asked)
    days = f"in the session {before!r}" if before else "on all days"
    legs = legs_of(values, asked.by)
    groups = sorted(legs["group"].unique(), key=in_order)
    counts = legs.groupby("group")["person"].nunique()
    ticks = tuple((float(at), f"{each} ({counts[each]})") for at, each in enumerate(groups))
    marks = [*clouds(legs, groups, values), *averages(answer.groups, groups)]
    name = capital(quantity_words(values.quantity))
    seen = view(ends(answer.groups), legs["value"].to_numpy(float))
    panel = Panel(
        Axis(ticks=ticks, limits=(-0.6, len(groups) - 0.4)),
        Axis(name, shown_unit(values.unit), seen),
        tuple(marks),
        size=HEIGHT,
    )
    return Picture(
        f"people-{values.quantity}",
        f"{name} of every leg of {counted(values.people, 'person', 'people')}; the means are in "
        "the tables.",
        f"A point is a leg: the mean of its drops {days}. Point at it to see whose it is, choose "
        "it to open that person.",
        (panel,),
    )


def shown(answer: Answer, asked: Asked) -> Values:
    """The values that are drawn: all, or those of before."""
    return answer.values.where(session=asked.before) if asked.before else answer.values


def in_order(group: str) -> tuple[bool, float, str]:
    """Doses by their size, words by their letters."""
    try:
        return False, float(group), group
    except ValueError:
        return True, 0.0, group


def legs_of(values: Values, by: str) -> Frame:
    """Means of legs with their group."""
    legs = means(values, ["person", "side"]).reset_index()
    each = values.frame.groupby(["person", "side"])
    legs["days"] = each["session"].nunique().to_numpy()
    legs["scatter"] = each["value"].std().to_numpy()
    group = EVERYONE
    if by and by in values.frame and values.frame[by].nunique() <= MOST_GROUPS:
        each = values.frame.drop_duplicates("person").set_index("person")[by].dropna().map(label)
        group = legs["person"].map(each).fillna("not known")
    return legs.assign(group=group)


def clouds(legs: Frame, groups: Sequence[str], values: Values) -> list[Mark]:
    """The points of each side."""
    place = legs["group"].map({each: float(at) for at, each in enumerate(groups)})
    order = legs.groupby("group").cumcount().to_numpy(float)
    across = place.to_numpy(float) + BREADTH * (2 * ((order * GOLDEN) % 1) - 1)
    made: list[Mark] = []
    for side in sorted(legs["side"].unique()):
        of = (legs["side"] == side).to_numpy()
        told = tuple(told_of(row, values) for row in legs[of].itertuples())
        made.append(
            Points(
                SIDES.get(side, Role.EITHER),
                across[of],
                legs["value"].to_numpy(float)[of],
                told=told,
                opens=tuple(legs["person"][of]),
            )
        )
    return made


def told_of(leg, values: Values) -> str:
    """What is said of a point: who, which side, the value, how often, and how far values lie apart:
    errors of single estimates would hold neither the drops nor the days.
    """
    unit = f" {shown_unit(values.unit)}".rstrip()
    amount = f"{counted(leg.drops, 'value')} of {counted(leg.days, 'session')}"
    if isfinite(leg.scatter):
        amount += f", with a standard deviation of {number(leg.scatter)}{unit}"
    who = f"{leg.person}, {leg.side}" if leg.side else str(leg.person)
    return f"{who}\n{number(leg.value, leg.value / 100)}{unit}\n{amount}"


def ends(found) -> list[float]:
    """Where the intervals of means end."""
    each = found.groups if isinstance(found, Comparison) else ()
    both = [end for one in each for end in (one.mean.low, one.mean.high)]
    return [end for end in both if isfinite(end)]


def averages(found, groups: Sequence[str]) -> list[Mark]:
    """The mean of each group, with its interval."""
    if not isinstance(found, Comparison):
        return []
    return [
        Points(
            Role.MEAN,
            np.array([float(groups.index(each.name))]),
            np.array([each.mean.value]),
            y_error=(each.mean.high - each.mean.low) / 2,
            told=(f"{each.name}: mean {with_interval(each.mean, found.unit)}",),
        )
        for each in found.groups
        if each.name in groups
    ]
