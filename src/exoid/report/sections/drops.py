"""What clinicians read off a drop: the measures of the pendulum test."""

from dataclasses import dataclass
from typing import ClassVar

from exoid.pendulum.drop import Drop, PendulumTest
from exoid.pendulum.drops import measure_drops
from exoid.report.parts.case import Case
from exoid.report.pictures.drops import show_drop
from exoid.report.pictures.panel import Picture
from exoid.report.sections.section import Section
from exoid.report.tables.drops import SOURCE, by_reason, loaded, mean, shown_unit, value
from exoid.report.tables.table import Column, Table
from exoid.report.words.text import counted

SHOWN = 4  # drops that are drawn; the first ones
AVERAGE = "mean ± sd"


@dataclass(frozen=True, eq=False)
class Drops(Section):
    """Every measure of every drop and its average, the curves, and what was not read and why."""

    name: ClassVar[str] = "drops"
    title: ClassVar[str] = "What is read off a drop"

    table: Table
    average: str
    figures: tuple[Picture, ...]
    refused: tuple[str, ...]
    source: str

    @classmethod
    def of(cls, case: Case) -> "Drops | None":
        if not case.sources:
            return None
        test = measure_drops([(source.name, source.recording) for source in case.sources])
        read = [drop for drop in test.drops if drop.reason is None]
        return cls(
            table=table_of(read, test),
            average=average(read, test),
            figures=tuple(show_drop(drop, number) for number, drop in enumerate(read[:SHOWN])),
            refused=tuple(refused(test)),
            source=SOURCE,
        )


def table_of(read: list[Drop], test: PendulumTest) -> Table:
    """One row per measure that any drop allows, one column per drop."""
    if not read:
        return Table("", {})
    known = {name: [drop.measures[name] for drop in read] for name in read[0].measures}
    known = {
        name: each for name, each in known.items() if any(one.value is not None for one in each)
    }
    first = [each[0] for each in known.values()]
    columns = {
        "measure": [one.title for one in first],
        "symbol": Column([one.symbol for one in first], symbols=True),
        "unit": [shown_unit(one.unit) for one in first],
    }
    if len(read) > 1:
        averages = [test.average.get(name) for name in known]
        columns[AVERAGE] = ["" if one is None else mean(one) for one in averages]
    for at, drop in enumerate(read):
        each = [row[at] for row in known.values()]
        columns[head(drop)] = ["" if one.value is None else value(one) for one in each]
    return Table("Measures of the pendulum test; ± is one standard error by the noise", columns)


def head(drop: Drop) -> str:
    return f"segment {drop.name}{loaded(drop)}"


def average(read: list[Drop], test: PendulumTest) -> str:
    """What the mean is over."""
    if len(read) < 2:
        return ""
    alike = counted(len(read) - len(test.left_out), "drop")
    others = ", ".join(test.left_out)
    without = f", not over those with another added mass (segment {others})" if others else ""
    return f"The mean and its standard deviation are over {alike}{without}."


def refused(test: PendulumTest) -> list[str]:
    """Segments and measures that were not read, by the reason."""
    whole = by_reason({drop.name: drop.reason for drop in test.drops if drop.reason})
    said = [f"Segment {', '.join(names)} not read: {reason}." for reason, names in whole.items()]
    for drop in test.drops:
        parts = by_reason({one.title: one.reason for one in drop.measures.values() if one.reason})
        said += [
            f"Of segment {drop.name} not read: {', '.join(titles)}: {reason}."
            for reason, titles in parts.items()
        ]
    return said
