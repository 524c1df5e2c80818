"""Where simulation and recording part: the torque that the baseline lacks."""

from collections.abc import Iterator

from exoid.mismatch.evidence.location import Location
from exoid.report.parts.case import Case
from exoid.report.pictures.mismatch.torque import (
    Called,
    called_in,
    parting_of,
    show_plane,
    show_torque,
    shown_of,
    worst,
)
from exoid.report.sections.blocks import Block, some
from exoid.report.sections.section import section
from exoid.report.tables.table import Table
from exoid.report.words.diagnosis.asserted import parted
from exoid.report.words.diagnosis.sentences import where
from exoid.report.words.text import capital

NOTHING = (
    "Nothing stands out: what is drawn here is how noise looks as a torque, and what the ends of "
    "segments make of it."
)


@section("parting", "Where they part")
def parting(case: Case) -> Iterator[Block]:
    """The missing torque over time, over the phase plane, and in words."""
    found = case.diagnosis
    if found is None:
        return
    numbers, location, called = worst(found), parting_of(found), called_in(found)
    yield capital(where(found)) if parted(found) else NOTHING
    if shown := shown_of(found):
        yield f"Shown are {shown}."
    yield from some([show_torque(location, number, called) for number in numbers])
    yield show_plane(location, called)
    if location.regions:
        yield regions(location, called)


def regions(location: Location, called: Called) -> Table:
    """The stretches where it is strongest."""
    each = location.regions
    columns = {
        "segment": [one.segment for one in each],
        "from [s]": [f"{one.begin:.2f}" for one in each],
        "to [s]": [f"{one.end:.2f}" for one in each],
        f"mean {called.noun} [{called.unit}]": [f"{one.torque:+.2g}" for one in each],
        "where": [one.region for one in each],
    }
    return Table(
        f"Where the missing {called.noun} is strongest; positive towards extension", columns
    )
