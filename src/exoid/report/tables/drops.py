"""The pendulum test as a person reads it: a table for every drop, what was not read and why."""

from rich.console import Console

from exoid.pendulum.drop import Drop, PendulumTest
from exoid.report.tables.table import Column, Table, print_table
from exoid.report.words.drop import EXPECTED, loaded, mean, unit_of, value
from exoid.report.words.text import by_reason, heading, note, say
from exoid.report.words.unlike_drops import of_mixed_ends, of_mixed_starts, of_unlike_rests

MOST = 40  # drops with a table of their own
A_E = (
    "A_e is the amplitude to the angle that swings shrink to: of a leg that was left until it hung "
    "still it is A0, of one that was stopped, moved or cut before it is what A0 would have been, "
    "had it swung on so."
)
SOURCE = (
    "Names after Rahimi et al., BioMedical Engineering OnLine 19:82, 2020; formulas in "
    "exoid.pendulum.definitions. Nothing here is a diagnosis."
)


def print_drops(test: PendulumTest, console: Console) -> None:
    """Every drop, unless they are many, the average, and the segments that were not read."""
    read = [drop for drop in test.drops if drop.reason is None]
    for drop in read if len(read) <= MOST else ():
        print_drop(drop, console)
    print_average(test, console)
    if len(read) > MOST:
        say(console, f"{len(read)} drops were read: a table of each would fill as many screens. "
            "--json FILE tells them all.")  # fmt: skip
    refused = by_reason((drop.name, drop.reason) for drop in test.drops)
    said = [f"{', '.join(names)}: {reason.rstrip('.')}." for reason, names in refused.items()]
    note(console, said, "Segments that were not read")
    if read:
        explain(test, console)


def explain(test: PendulumTest, console: Console) -> None:
    """What the numbers hold, and where they are from."""
    heading(console, "About these numbers")
    for reason, names in by_reason((drop.name, drop.note) for drop in test.drops).items():
        say(console, f"Segment {', '.join(names)}: {reason}.")
    say(console, "± is one standard error by the noise of the angle; of an average, the standard "
        "deviation over drops. Angles are negative in flexion, 0 is the extended knee; amplitudes, "
        "peak velocities and accelerations are sizes, whichever way the leg moves. Start angle and "
        "plateau hold what the sensor's zero is off, which no drop tells without a model of the "
        "leg, and of which ± holds nothing; amplitudes and indices do not.")  # fmt: skip
    if EXPECTED in test.average:
        say(console, A_E)
    say(console, SOURCE)


def print_drop(drop: Drop, console: Console) -> None:
    """One drop: what was read, and why the rest was not."""
    begins = f", which begins at {drop.segment.begins:.2f} s" if drop.segment.begins else ""
    title = f"Drop of segment {drop.name}{begins}{loaded(drop)}"
    read = [each for each in drop.measures.values() if each.value is not None]
    columns = {
        "measure": [each.title for each in read],
        "symbol": Column([each.symbol for each in read], head=""),
        "value": [value(each) for each in read],
        "unit": [unit_of(each) for each in read],
        "at [s]": [f"{each.marks[-1].time:.2f}" if each.marks else "" for each in read],
    }
    print_table(Table("", columns, title), console)
    if drop.halt:
        say(console, f"- {drop.halt}.", hanging=2)
    refused = by_reason((each.title, each.reason) for each in drop.measures.values())
    for reason, titles in refused.items():
        say(console, f"- not read: {', '.join(titles)}: {reason.rstrip('.')}.", hanging=2)


def print_average(test: PendulumTest, console: Console) -> None:
    """Means over the drops that can be compared, where there are several."""
    if all(len(one.drops) < 2 for one in test.average.values()):
        return
    each = list(test.average.values())
    columns = {
        "measure": [one.title for one in each],
        "symbol": Column([one.symbol for one in each], head=""),
        "mean ± sd": [mean(one) for one in each],
        "unit": [unit_of(one) for one in each],
        "drops": [str(len(one.drops)) for one in each],
    }
    print_table(Table("", columns, "Average over drops"), console)
    if test.left_out:
        names = ", ".join(test.left_out)
        say(console, f"Not in it, with another added mass: segment {names}.")
    for said in (of_mixed_starts(test), of_mixed_ends(test), of_unlike_rests(test)):
        if said:
            say(console, said)
