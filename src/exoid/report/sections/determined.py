"""What the recording determined, what it left open, and who else had a say."""

from dataclasses import dataclass
from typing import ClassVar

from exoid.report.parts.case import Case
from exoid.report.pictures.determined import show_shares
from exoid.report.pictures.panel import Picture
from exoid.report.sections.section import Section
from exoid.report.tables.leg import quantities_of
from exoid.report.tables.table import Column, Table
from exoid.trust.told import Identifiability

ALONE = "Every segment was fitted alone, so there is no one fit to ask what the data determine."


@dataclass(frozen=True, eq=False)
class Determined(Section):
    """Identifiability in sentences, the combinations that the data fix, and shares."""

    name: ClassVar[str] = "told"
    title: ClassVar[str] = "What the data determine"

    sentences: tuple[str, ...]
    combinations: Table
    segments: Table
    figure: Picture

    @classmethod
    def of(cls, case: Case) -> "Determined":
        told = case.told
        return cls(
            sentences=(ALONE,) if told is None else said(told),
            combinations=combinations(told),
            segments=segments(told, [each.name for each in case.fit.segments]),
            figure=show_shares(case.fit),
        )


def said(told: Identifiability) -> tuple[str, ...]:
    """What is told first, then what is not."""
    symbols = ", ".join(each.symbol for each in told.combinations.values())
    first = f"By itself, without prior and limits, this recording tells: {symbols or 'nothing'}."
    return (first, *told.sentences)


def combinations(told: Identifiability | None) -> Table:
    """What the data alone determine, with the data's own errors."""
    each = [] if told is None else list(told.combinations.values())
    columns = {
        "quantity": [one.title for one in each],
        "symbol": Column([one.symbol for one in each], symbols=True),
        "value": quantities_of(each),
    }
    return Table("From the data alone", columns)


def segments(told: Identifiability | None, names: list[str]) -> Table:
    """Which segment told what part of it."""
    if told is None or not told.segment_shares:
        return Table("", {})
    shares = {
        told.combinations[name].symbol: [f"{part:.0%}" for part in parts]
        for name, parts in told.segment_shares.items()
    }
    return Table("Which segments told it", {"segment": names, **shares})
