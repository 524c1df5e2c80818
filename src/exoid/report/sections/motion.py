"""Measured against simulated motion, segment by segment."""

from dataclasses import dataclass
from typing import ClassVar

from exoid.fitting.result.fit_result import SegmentFit
from exoid.report.parts.case import Case
from exoid.report.pictures.motion import chosen_segments, show_motion
from exoid.report.pictures.panel import Picture
from exoid.report.sections.section import Section
from exoid.report.tables.fit import reading
from exoid.report.tables.leg import segments
from exoid.report.tables.table import Table

PRINTED = 2  # segments on paper


@dataclass(frozen=True, eq=False)
class Motion(Section):
    """A figure for every segment, or for those that fit worst; all of them in a table."""

    name: ClassVar[str] = "motion"
    title: ClassVar[str] = "Measured against simulated"

    figures: tuple[tuple[str, Picture], ...]  # with their titles
    left_out: int
    printed: tuple[str, ...]  # names of the figures that paper has room for
    table: Table
    reading: str  # of Eq. 4; empty without cycles

    @classmethod
    def of(cls, case: Case) -> "Motion":
        fit, chosen = case.fit, chosen_segments(case.fit)
        found = case.diagnosis
        before = found.before.segments if found is not None and found.after is not None else []
        bare = {each.name: each for each in before}
        drawn = tuple(
            (f"Segment {each.name}, {each.kind}", show_motion(each, number, bare.get(each.name)))
            for number, each in enumerate(chosen)
        )
        return cls(
            figures=drawn,
            left_out=len(fit.segments) - len(chosen),
            printed=tuple(drawn[number][1].name for number in largest(chosen)),
            table=segments(fit.segments),
            reading="" if fit.torque_frequency is None else reading(fit),
        )


def largest(chosen: list[SegmentFit]) -> list[int]:
    """Where the residual is largest, the worst first."""
    ranked = sorted(range(len(chosen)), key=lambda at: -chosen[at].angle_rmse)
    return ranked[:PRINTED]
