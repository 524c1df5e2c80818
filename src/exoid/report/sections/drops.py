"""What clinicians read off a drop: the measures of the pendulum test."""

from collections.abc import Iterator

from exoid.files.counted import counted
from exoid.pendulum.drop import Drop, PendulumTest
from exoid.pendulum.drops import measure_drops
from exoid.report.parts.case import Case
from exoid.report.pictures.drops import show_drop
from exoid.report.sections.blocks import Block, element, some
from exoid.report.sections.section import section
from exoid.report.tables.drops import SOURCE
from exoid.report.tables.table import Column, Table
from exoid.report.words.drop import loaded, mean, unit_of, value
from exoid.report.words.text import by_reason
from exoid.report.words.unlike_drops import of_mixed_ends, of_mixed_starts, of_unlike_rests

SHOWN = 4  # drops that are drawn; the first ones
AVERAGE = "mean ± sd"


@section("drops", "What is read off a drop")
def drops(case: Case) -> Iterator[Block]:
    """Every measure of every drop and its average, the curves, and what was not read and why."""
    if not case.sources:
        return
    test = measure_drops([(source.name, source.recording) for source in case.sources])
    read = [drop for drop in test.drops if drop.reason is None]
    if read:
        yield from some([show_drop(drop, number) for number, drop in enumerate(read[:SHOWN])])
        yield table_of(read, test)
    if len(read) > 1:
        yield element("p", average(read, test))
    yield refused(test)
    yield element("p", SOURCE, "small")


def table_of(read: list[Drop], test: PendulumTest) -> Table:
    """One row per measure that any drop allows, one column per drop."""
    known = {name: [drop.measures[name] for drop in read] for name in read[0].measures}
    known = {
        name: each for name, each in known.items() if any(one.value is not None for one in each)
    }
    first = [each[0] for each in known.values()]
    columns = {
        "measure": [one.title for one in first],
        "symbol": Column([one.symbol for one in first], symbols=True),
        "unit": [unit_of(one) for one in first],
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
    alike = counted(len(read) - len(test.left_out), "drop")
    others = ", ".join(test.left_out)
    without = f", not over those with another added mass (segment {others})" if others else ""
    said = f"The mean and its standard deviation are over {alike}{without}."
    return " ".join(
        filter(None, (said, of_mixed_starts(test), of_mixed_ends(test), of_unlike_rests(test)))
    )


def refused(test: PendulumTest) -> list[str]:
    """Segments and measures that were not read, by the reason, and errors that say little."""
    whole = by_reason((drop.name, drop.reason) for drop in test.drops)
    said = [f"Segment {', '.join(names)} not read: {reason}." for reason, names in whole.items()]
    noted = by_reason((drop.name, drop.note) for drop in test.drops)
    said += [f"Segment {', '.join(names)}: {note}." for note, names in noted.items()]
    said += [f"Segment {drop.name}: {drop.halt}." for drop in test.drops if drop.halt]
    for drop in test.drops:
        parts = by_reason((one.title, one.reason) for one in drop.measures.values())
        said += [
            f"Of segment {drop.name} not read: {', '.join(titles)}: {reason}."
            for reason, titles in parts.items()
        ]
    return said
