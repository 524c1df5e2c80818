"""Measured against simulated motion, segment by segment."""

from collections.abc import Iterator

from exoid.fitting.result.segment_fit import SegmentFit
from exoid.report.parts.case import Case
from exoid.report.pictures.motion import chosen_segments, show_motion
from exoid.report.sections.blocks import Block, Group, element
from exoid.report.sections.section import section
from exoid.report.tables.fit import reading
from exoid.report.tables.leg import segments

PRINTED = 2  # segments on paper
HOW = (
    "Drag across a figure to zoom in on a stretch of time; all segments follow. Double-click to "
    "see all of it again. On a touch screen the buttons above a figure zoom; on the keyboard plus "
    "and minus zoom, the arrow keys move, and 0 shows all."
)


@section("motion", "Measured against simulated")
def motion(case: Case) -> Iterator[Block]:
    """A figure for every segment, or for those that fit worst; all of them in a table."""
    fit, chosen, found = case.fit, chosen_segments(case.fit), case.diagnosis
    before = found.before.segments if found is not None and found.after is not None else []
    bare = {each.name: each for each in before}
    left, printed = len(fit.segments) - len(chosen), largest(chosen)
    yield element("p", HOW, "screen")
    if left:
        shown = f"Shown are the {len(chosen)} segments with the largest residual"
        yield f"{shown}; {left} more are in the table."
    if len(printed) < len(chosen):
        shown = f"On paper are the {len(printed)} with the largest residual"
        yield element("p", f"{shown}; all are in the table.", "paper")
    drawn = []
    for number, each in enumerate(chosen):
        title = element("h3", f"Segment {each.name}, {each.kind}")
        blocks = title, show_motion(each, number, bare.get(each.name))
        drawn.append(Group("div", blocks, "" if number in printed else "screen"))
    yield Group("div", drawn, "grid")
    yield segments(fit.segments)
    if fit.torque_frequency is not None:
        yield f"Torque frequency: {reading(fit)}."


def largest(chosen: list[SegmentFit]) -> list[int]:
    """Where the residual is largest, the worst first."""
    ranked = sorted(range(len(chosen)), key=lambda at: -chosen[at].angle_rmse)
    return ranked[:PRINTED]
