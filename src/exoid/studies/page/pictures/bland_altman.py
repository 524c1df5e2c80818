"""Differences over means, a person a point."""

from exoid.report.pictures.axis import view
from exoid.report.pictures.panel import Axis, Band, Mark, Note, Panel, Picture, Points, Rule
from exoid.report.pictures.role import Role
from exoid.report.words.text import capital, quantity_words, shown_unit
from exoid.studies.page.parts.words import number
from exoid.studies.statistics.agreement import Agreement

HEIGHT = 4.6  # size of the panel
ABOVE = 0.035  # of the panel, by which words stand above their line


def bland_altman(found: Agreement, name: str) -> Picture:
    """Differences over means, with the limits of agreement."""
    pairs = found.pairs
    apart, mean = pairs.difference.to_numpy(float), pairs.mean.to_numpy(float)
    half = (found.upper.high - found.upper.low) / 2
    unit = f" {shown_unit(pairs.unit)}".rstrip()
    told = tuple(
        f"{who}\n{pairs.second} - {pairs.first}: {number(one, half)}{unit}"
        for who, one in zip(pairs.frame.index, apart, strict=True)
    )
    ends = [found.lower.low, found.upper.high]
    lines = (
        ("mean", found.bias, Role.BIAS),
        ("upper limit", found.upper, Role.AGREED),
        ("lower limit", found.lower, Role.AGREED),
    )
    marks: list[Mark] = [Rule(Role.ZERO, 0.0)]
    low, high = seen = view(ends, apart)
    above = ABOVE * (high - low)
    for words, each, role in lines:
        marks += [Band(Role.INTERVAL, each.low, each.high), Rule(role, each.value)]
        marks.append(Note(f"{words} {number(each.value, half)}", 0.99, each.value + above))
    marks.append(
        Points(Role.EITHER, mean, apart, told=told, opens=tuple(map(str, pairs.frame.index)))
    )
    what = quantity_words(pairs.quantity)
    panel = Panel(
        Axis(f"mean of {pairs.first} and {pairs.second}", shown_unit(pairs.unit), view([], mean)),
        Axis(f"{pairs.second} - {pairs.first}", shown_unit(pairs.unit), seen),
        tuple(marks),
        size=HEIGHT,
    )
    return Picture(
        name,
        f"Differences of {what} between {pairs.first} and {pairs.second} over their means, for "
        f"{found.people} people; the numbers are in the table.",
        f"{capital(what)} (Bland and Altman): a point is a person. 95 % of people lie between the "
        "dashed lines; the bands are how sure the lines are.",
        (panel,),
    )
