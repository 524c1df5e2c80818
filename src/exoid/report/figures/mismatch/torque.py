"""The torque that the baseline lacks, over time, and by what was found."""

import numpy as np

from exoid.mismatch.evidence.locate import Location, Missing
from exoid.report.figures.figure import Figure
from exoid.report.figures.style import (
    BAND,
    FOUND_LINE,
    PLAIN_LINE,
    STRONGEST,
    blank,
    curve,
)
from exoid.report.plots.diagnosis import MODELLED, TORQUE

HEIGHT = 300  # pixels
HOVER = "%{y:.3f} N m"


def draw_torque(location: Location, number: int) -> Figure:
    """Of one segment [N m], with twice its noise and the stretches where it is strongest."""
    each = location.missing[number]
    drawing = blank(HEIGHT, hovermode="x unified")
    drawing.add_hrect(-2 * each.band, 2 * each.band, **BAND)
    for region in location.regions:
        if region.segment == each.segment:
            drawing.add_vrect(region.begin, region.end, **STRONGEST)
    curves = [(TORQUE["label"], each.torque, PLAIN_LINE)]
    if each.modelled is not None:
        curves.append((MODELLED["label"], each.modelled, FOUND_LINE))
    for name, torque, line in curves:
        curve(drawing, each.time, torque, name=name, line=line, hovertemplate=HOVER)
    drawing.update_xaxes(title_text="time [s]", hoverformat=".2f")
    drawing.update_yaxes(title_text="missing torque [N m]")
    return Figure(f"torque-{number}", alternative(each), caption(each), drawing, "whole")


def alternative(each: Missing) -> str:
    largest = float(np.max(np.abs(each.torque)))
    return (
        f"The torque in N m that Eq. 9 lacks in segment {each.segment}, over time in s: at most "
        f"{largest:.2g} N m, with a noise of {each.band:.2g} N m (one standard deviation)."
    )


def caption(each: Missing) -> str:
    return (
        f"Segment {each.segment}. Grey band: noise, twice its standard deviation of "
        f"{each.band:.2g} N m. Amber: where the torque is strongest."
    )
