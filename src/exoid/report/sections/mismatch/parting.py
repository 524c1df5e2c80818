"""Where simulation and recording part: the torque that the baseline lacks."""

from dataclasses import dataclass
from typing import ClassVar

from exoid.mismatch.answer.diagnosis import Diagnosis
from exoid.mismatch.evidence.location import Location
from exoid.report.parts.case import Case
from exoid.report.pictures.mismatch.torque import show_plane, show_torque, worst
from exoid.report.pictures.panel import Picture
from exoid.report.sections.section import Section
from exoid.report.tables.table import Table
from exoid.report.words.diagnosis import only_sensors, where
from exoid.report.words.text import capital

NOTHING = (
    "Nothing stands out: what is drawn here is how noise looks as a torque, and what the ends of "
    "segments make of it."
)


@dataclass(frozen=True, eq=False)
class Parting(Section):
    """The missing torque over time, over the phase plane, and in words."""

    name: ClassVar[str] = "parting"
    title: ClassVar[str] = "Where they part"

    sentence: str
    figures: tuple[Picture, ...]
    left_out: int
    plane: Picture
    regions: Table

    @classmethod
    def of(cls, case: Case) -> "Parting | None":
        found = case.diagnosis
        if found is None:
            return None
        numbers, location = worst(found), found.location
        return cls(
            sentence=capital(where(found)) if parted(found) else NOTHING,
            figures=tuple(show_torque(location, number) for number in numbers),
            left_out=len(location.missing) - len(numbers),
            plane=show_plane(location),
            regions=regions(location),
        )


def parted(found: Diagnosis) -> bool:
    """Is a torque missing?"""
    return found.verdict != "none" and not only_sensors(found)


def regions(location: Location) -> Table:
    """The stretches where it is strongest."""
    each = location.regions
    columns = {
        "segment": [one.segment for one in each],
        "from [s]": [f"{one.begin:.2f}" for one in each],
        "to [s]": [f"{one.end:.2f}" for one in each],
        "mean torque [N m]": [f"{one.torque:+.2g}" for one in each],
        "where": [one.region for one in each],
    }
    return Table("Where the missing torque is strongest; positive towards extension", columns)
