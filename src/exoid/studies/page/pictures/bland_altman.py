"""Differences over means, a person a point."""

from collections.abc import Iterator

from exoid.report.pictures.axis import view
from exoid.report.pictures.panel import Axis, Band, Mark, Note, Panel, Picture, Points, Rule
from exoid.report.pictures.role import Role
from exoid.report.words.text import capital, quantity_words, shown_unit
from exoid.studies.page.parts.numbers import number
from exoid.studies.statistics.agreement import Agreement

HEIGHT = 4.6  # size of the panel
ABOVE = 0.035  # of the panel, by which words stand above their line


def bland_altman(found: Agreement, name: str) -> Picture:
    """Differences over means, with the limits of agreement."""
    pairs = found.pairs
    seen = view([found.lower.low, found.upper.high], pairs.difference.to_numpy(float))
    unit, between = shown_unit(pairs.unit), f"{pairs.first} and {pairs.second}"
    panel = Panel(
        Axis(f"mean of {between}", unit, view([], pairs.mean.to_numpy(float))),
        Axis(f"{pairs.second} - {pairs.first}", unit, seen),
        (Rule(Role.ZERO, 0.0), *lines(found, ABOVE * (seen[1] - seen[0])), people(found)),
        size=HEIGHT,
    )
    what = quantity_words(pairs.quantity)
    return Picture(
        name,
        f"Differences of {what} between {between} over their means, for {found.people} people; the "
        "numbers are in the table.",
        f"{capital(what)} (Bland and Altman): a point is a person. 95 % of people lie between the "
        "dashed lines; the bands are how sure the lines are.",
        (panel,),
    )


def lines(found: Agreement, above: float) -> Iterator[Mark]:
    """Mean and limits with their intervals, and their names a little above them."""
    for words, each, role in (
        ("mean", found.bias, Role.BIAS),
        ("upper limit", found.upper, Role.AGREED),
        ("lower limit", found.lower, Role.AGREED),
    ):
        yield Band(Role.INTERVAL, each.low, each.high)
        yield Rule(role, each.value)
        yield Note(f"{words} {number(each.value, half(found))}", 0.99, each.value + above)


def people(found: Agreement) -> Points:
    """A point each, which says whose it is."""
    pairs = found.pairs
    unit = f" {shown_unit(pairs.unit)}".rstrip()
    apart = pairs.difference.to_numpy(float)
    told = tuple(
        f"{who}\n{pairs.second} - {pairs.first}: {number(float(one), half(found))}{unit}"
        for who, one in zip(pairs.frame.index, apart, strict=True)
    )
    opens = tuple(map(str, pairs.frame.index))
    return Points(Role.EITHER, pairs.mean.to_numpy(float), apart, told=told, opens=opens)


def half(found: Agreement) -> float:
    """The half width of a limit's interval: what digits there are."""
    return (found.upper.high - found.upper.low) / 2
