"""What the recording determined, what it left open, and who else had a say."""

from collections.abc import Iterator

from exoid.fitting.result.refused.without_numbers import REFUSED
from exoid.report.parts.case import Case
from exoid.report.pictures.determined import show_shares
from exoid.report.sections.blocks import Block, Group, element
from exoid.report.sections.section import section
from exoid.report.tables.leg import in_print, quantities_of
from exoid.report.tables.table import Column, Table
from exoid.report.words.text import capital
from exoid.trust.identifiability import Identifiability

ALONE = "Every segment was fitted alone, so there is no one fit to ask what the data determine."


@section("told", "What the data determine")
def determined(case: Case) -> Iterator[Block]:
    """Identifiability in sentences, the combinations that the data fix, and shares."""
    told = case.told
    if not case.fit.follows:
        yield [f"{capital(REFUSED)}."]
        return
    yield [ALONE] if told is None else said(told)
    yield show_shares(case.fit)
    if told is None:
        return
    yield combinations(told)
    if told.segment_shares:
        shares = segments(told, [each.name for each in case.fit.segments])
        yield Group("details", [element("summary", "Which segments told it"), shares])


def said(told: Identifiability) -> list[str]:
    """What is told first, then what is not."""
    symbols = ", ".join(each.symbol for each in told.combinations.values())
    first = f"By itself, without prior and limits, this recording tells: {symbols or 'nothing'}."
    return [first, *told.sentences]


def combinations(told: Identifiability) -> Table:
    """What the data alone determine, with the data's own errors."""
    each = list(told.combinations.values())
    columns = {
        "quantity": [one.title for one in each],
        "symbol": Column([one.symbol for one in each], symbols=True),
        "value": quantities_of([in_print(one) for one in each]),
    }
    return Table("From the data alone", columns)


def segments(told: Identifiability, names: list[str]) -> Table:
    """Which segment told what part of it."""
    shares = {
        told.combinations[name].symbol: [f"{part:.0%}" for part in parts]
        for name, parts in told.segment_shares.items()
    }
    return Table("Which segments told it", {"segment": names, **shares})
