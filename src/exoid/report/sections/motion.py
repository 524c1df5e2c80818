"""Measured against simulated motion, segment by segment."""

from dataclasses import dataclass
from typing import ClassVar

from exoid.fitting.result.fit_result import FitResult, SegmentFit
from exoid.report.parts.case import Case
from exoid.report.pictures.motion import chosen_segments, show_motion
from exoid.report.pictures.panel import Picture
from exoid.report.sections.section import Section
from exoid.report.sections.table import Table
from exoid.report.tables.fit import reading, torque
from exoid.report.words.text import in_degrees

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
        drawn = tuple(
            (f"Segment {each.name}, {each.kind}", show_motion(each, number))
            for number, each in enumerate(chosen)
        )
        return cls(
            figures=drawn,
            left_out=len(fit.segments) - len(chosen),
            printed=tuple(drawn[number][1].name for number in largest(chosen)),
            table=misfits(fit),
            reading="" if fit.torque_frequency is None else reading(fit),
        )


def largest(chosen: list[SegmentFit]) -> list[int]:
    """Where the residual is largest, the worst first."""
    ranked = sorted(range(len(chosen)), key=lambda at: -chosen[at].angle_rmse)
    return ranked[:PRINTED]


def misfits(fit: FitResult) -> Table:
    """How far simulation and measurement are apart, beside the noise."""
    each = fit.segments
    velocity = [one.velocity_rmse for one in each]
    columns = {
        "segment": [one.name for one in each],
        "kind": [one.kind for one in each],
        "period T [s]": ["" if one.period is None else f"{one.period:.4g}" for one in each],
        "torque tau [N m]": [torque(one) for one in each],
        "added mass [kg]": [f"{one.added_mass:.3g}" if one.added_mass else "" for one in each],
        "angle RMSE [deg]": [in_degrees(one.angle_rmse) for one in each],
        "times the noise": [f"{one.angle_rmse / one.angle_noise:.3g}" for one in each],
        "velocity RMSE [deg/s]": ["" if one is None else in_degrees(one) for one in velocity],
    }
    return Table("How far measured and simulated are apart", columns)
