"""Values with their intervals, row by row."""

from collections.abc import Sequence

import numpy as np

from exoid.report.pictures.axis import view
from exoid.report.pictures.panel import Axis, Bars, Panel, Picture, Points, Rule
from exoid.report.pictures.role import Role
from exoid.report.words.text import quantity_words
from exoid.studies.page.parts.numbers import tells, with_interval
from exoid.studies.page.parts.words import cause_words, column_words
from exoid.studies.statistics.groups import Comparison
from exoid.studies.statistics.physics import Cause
from exoid.studies.statistics.reliability import Reliability
from exoid.studies.statistics.tables.said import Interval

ROW = 0.5  # size of a row


def intervals(
    rows: dict[str, Interval], axis: Axis, name: str, said: tuple[str, str], guides=()
) -> Picture:
    """Rows of a value with its interval; `said` is for those who do not see it, and do."""
    at = np.arange(len(rows), dtype=float)
    each = list(rows.values())
    low, value, high = (
        np.array([getattr(one, end) for one in each]) for end in ("low", "value", "high")
    )
    told = tuple(f"{row}: {with_interval(one)}" for row, one in rows.items())
    ticks = tuple((float(place), row) for place, row in zip(at, rows, strict=True))
    panel = Panel(
        axis,
        Axis(ticks=ticks, reversed=True),
        (
            *(Rule(Role.GUIDE, guide, upright=True) for guide in guides),
            Bars(Role.SURE, at, high - low, low),
            Points(Role.CENTRE, value, at, told=told),
        ),
        size=ROW * len(rows) + 0.4,
    )
    return Picture(name, *said, (panel,))


def reliabilities(found: Sequence[Reliability]) -> Picture:
    rows = {quantity_words(each.quantity): each.agreement for each in found}
    lowest = min([0.0, *(each.low for each in rows.values() if each.low == each.low)])
    return intervals(
        rows,
        Axis("ICC(A,1) of one day", "", (max(lowest, -1.0), 1.02)),
        "reliability-figure",
        (
            "The intraclass correlation of every quantity with its interval, as in the table.",
            "1: days of a leg are alike. 0: they tell people apart no better than chance. Lines at "
            "0.5, 0.75 and 0.9 part poor, moderate, good and excellent.",
        ),
        (0.5, 0.75, 0.9),
    )


def effects(found: Sequence[Comparison]) -> Picture | None:
    """Hedges' g of two groups, where it is told; of more there is no one number."""
    rows = {
        quantity_words(each.quantity): each.differences[0].g
        for each in found
        if len(each.differences) == 1 and tells(each.differences[0].g)
    }
    if len(rows) < 2:
        return None
    one = found[0].differences[0]
    ends = [end for each in rows.values() for end in (each.low, each.high)]
    return intervals(
        rows,
        Axis(f"Hedges g: {one.second} less {one.first}", "", view([0.0, *ends], np.zeros(0))),
        "effects-figure",
        (
            "The standardised difference of every quantity with its interval, as in the table.",
            "Differences in standard deviations of people: 0.2 is called small, 0.5 medium, 0.8 "
            "large.",
        ),
        (0.0,),
    )


def causes(found: Sequence[Cause], groups: Sequence[str], by: str) -> Picture:
    """The share of people in whom each was found."""
    kept = [each for each in found if each.group in groups]
    several = len(groups) > 1
    rows = {
        f"{cause_words(each.name)}{f', {each.group}' if several else ''}": Interval(
            *(100 * end for end in (each.share.value, each.share.low, each.share.high))
        )
        for each in kept
    }
    of = f" by {column_words(by)}" if several else ""
    return intervals(
        rows,
        Axis("share of people", "%", (-2.0, 102.0)),
        "physics-figure",
        (
            f"The share of people in whom each cause was found{of}, as in the table.",
            "In at least one recording of a person; the bar is Wilson's 95 % interval.",
        ),
    )
