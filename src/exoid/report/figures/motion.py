"""Measured against simulated motion of a segment, the residuals below, all on one time axis."""

from dataclasses import dataclass

import numpy as np
from plotly.graph_objects import Figure as Drawing

from exoid.fitting.result.fit_result import SegmentFit
from exoid.report.figures.figure import Figure
from exoid.report.figures.style import (
    BAND,
    MEASURED_LINE,
    RESIDUAL_LINE,
    SIMULATED_LINE,
    Samples,
    blank,
    curve,
    stacked,
    thinned,
)
from exoid.report.words.text import in_degrees

HEIGHTS = (3.0, 1.7)  # of a channel and its residual
GAP = 0.03
PANEL, REST = 64, 84  # pixels for each unit of height, and for legend and time axis


@dataclass(frozen=True, eq=False)
class Channel:
    """What one sensor showed of a segment [deg or deg/s]."""

    title: str
    unit: str
    measured: Samples
    simulated: Samples
    noise: float
    misfit: float  # root mean square of the residual


def channels(segment: SegmentFit) -> list[Channel]:
    """The encoder's, and the gyro's where there is one."""
    found = [
        Channel(
            "angle",
            "deg",
            np.degrees(segment.angle),
            np.degrees(segment.simulated_angle),
            float(np.degrees(segment.angle_noise)),
            segment.angle_rmse,
        )
    ]
    measured, noise, misfit = (
        segment.angular_velocity,
        segment.velocity_noise,
        segment.velocity_rmse,
    )
    if measured is not None and noise is not None and misfit is not None:
        simulated = np.degrees(segment.simulated_velocity)
        width = float(np.degrees(noise))
        found.append(Channel("velocity", "deg/s", np.degrees(measured), simulated, width, misfit))
    return found


def draw_motion(segment: SegmentFit, number: int) -> Figure:
    """Each channel over time [s], and below it simulated - measured over the sensor's noise."""
    each = channels(segment)
    heights = [height for _ in each for height in HEIGHTS]
    drawing = blank(int(PANEL * sum(heights)) + REST, hovermode="x unified", hoversubplots="axis")
    for row, place in enumerate(stacked(heights, GAP), start=1):
        one = each[(row - 1) // 2]
        title = f"{one.title if row % 2 else 'residual'} [{one.unit}]"
        drawing.update_layout({f"yaxis{row}": {"domain": place, "title": {"text": title}}})
    drawing.update_xaxes(title_text="time [s]", anchor=f"y{len(heights)}", hoverformat=".2f")
    for at, one in enumerate(each):
        draw_channel(drawing, segment.time, one, (f"y{2 * at + 1}", f"y{2 * at + 2}"))
    return Figure(f"motion-{number}", alternative(segment), caption(segment), drawing, "time")


def draw_channel(drawing: Drawing, time: Samples, each: Channel, rows: tuple[str, str]) -> None:
    """Measured and simulated in the first row, the residual with the noise in the second."""
    above, below = rows
    named = above == "y1"  # every thing once in the legend
    curves = (
        ("measured", each.measured, MEASURED_LINE, above),
        ("simulated", each.simulated, SIMULATED_LINE, above),
        ("residual", each.simulated - each.measured, RESIDUAL_LINE, below),
    )
    drawing.add_hrect(-2 * each.noise, 2 * each.noise, yref=below, **BAND)
    for name, samples, line, row in curves:
        curve(
            drawing,
            time,
            samples,
            yaxis=row,
            name=name,
            legendgroup=name,
            showlegend=named,
            line=line,
            hovertemplate=f"%{{y:.3f}} {each.unit}",
        )


def alternative(segment: SegmentFit) -> str:
    """For those who do not see it."""
    each = channels(segment)
    shown = " and ".join(f"{one.title} in {one.unit}" for one in each)
    return (
        f"Segment {segment.name}: {shown} over time in s, measured and simulated, each with its "
        f"residual below. The root mean square of the residual is {misfits(each)}."
    )


def caption(segment: SegmentFit) -> str:
    """For those who do."""
    each = channels(segment)
    step = thinned(segment.time).step
    drawn = "" if step == 1 else f" One sample in {step} is drawn."
    return (
        f"Residual (simulated minus measured): {misfits(each)} RMSE. Grey: twice the noise of the "
        f"sensor, {in_degrees(segment.angle_noise)} deg for the angle.{drawn}"
    )


def misfits(each: list[Channel]) -> str:
    return ", ".join(f"{in_degrees(one.misfit)} {one.unit}" for one in each)
