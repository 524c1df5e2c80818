"""The motion of a fit: measured against simulated, and what the model leaves over."""

from math import ceil
from textwrap import fill

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import SubFigure
from matplotlib.ticker import MaxNLocator

from exoid.fitting.result.fit_result import FitResult, SegmentFit
from exoid.report.plots.style import MEASURED, NOISE, RESIDUAL, SIMULATED, name_all
from exoid.report.words.text import in_degrees

SHOWN = 15  # segments; of more, those that fit worst
LABELS = ("angle\n[deg]", "residual\n[deg]", "angular velocity\n[deg/s]", "residual\n[deg/s]")


def chosen_segments(result: FitResult) -> list[SegmentFit]:
    """All segments, or those that fit worst where there are too many to read; in their order."""
    worst = sorted(range(len(result.segments)), key=lambda at: -result.segments[at].angle_rmse)
    return [result.segments[at] for at in sorted(worst[:SHOWN])]


def draw_motion(figure: SubFigure, segments: list[SegmentFit], across: int) -> None:
    """Panels per segment, in bands of `across`; each quantity on one scale throughout."""
    gyro = any(each.angular_velocity is not None for each in segments)
    heights = [3, 1.6, 3, 1.6][: 4 if gyro else 3]
    rows: list[list[Axes]] = [[] for _ in heights]
    parts = figure.subfigures(ceil(len(segments) / across), 1, squeeze=False)
    for number, part in enumerate(parts[:, 0]):
        each = segments[number * across : (number + 1) * across]
        panels = part.subplots(
            len(heights), across, sharex="col", squeeze=False, height_ratios=heights
        )
        for column, segment in enumerate(each):
            draw_segment(segment, list(panels[:, column]))
        for row, (axes, same) in enumerate(zip(panels, rows, strict=True)):
            same.extend(axes[: len(each)])
            decorate(list(axes), row, len(each), last=row == len(heights) - 1)
        part.align_ylabels(panels[:, 0])
    for same in rows:
        share_scale(same)
    name_all(figure, [axes for same in rows for axes in same], "outside upper center")


def share_scale(panels: list[Axes]) -> None:
    """One vertical scale for all panels that hold data."""
    filled = [axes for axes in panels if axes.lines]
    lower, upper = zip(*(axes.get_ylim() for axes in filled), strict=True)
    for axes in filled:
        axes.set_ylim(min(lower), max(upper))


def draw_segment(segment: SegmentFit, panels: list[Axes]) -> None:
    """Angle, its residual, angular velocity, its residual [deg, deg/s] over time [s]."""
    draw_channel(
        panels[:2], segment.time, segment.simulated_angle, segment.angle, segment.angle_noise
    )
    draw_channel(
        panels[2:],
        segment.time,
        segment.simulated_velocity,
        segment.angular_velocity,
        segment.velocity_noise,
    )
    rmse = f"RMSE {in_degrees(segment.angle_rmse)} deg"
    panels[0].set_title(f"{fill(f'segment {segment.name}', 26)}\n{rmse}", loc="left")
    if segment.velocity_rmse is not None:
        panels[2].set_title(f"RMSE {in_degrees(segment.velocity_rmse)} deg/s", loc="left")


def draw_channel(panels: list[Axes], time, simulated, measured, noise) -> None:
    """One quantity in degrees and, below it, its residual with the noise band."""
    if measured is not None:
        panels[0].plot(time, np.degrees(measured), **MEASURED)
        if noise is not None:
            panels[1].axhspan(-2 * np.degrees(noise), 2 * np.degrees(noise), **NOISE)
        panels[1].plot(time, np.degrees(simulated - measured), **RESIDUAL)
    elif len(panels) > 1:
        centre = {"transform": panels[1].transAxes, "ha": "center", "va": "center"}
        panels[1].text(0.5, 0.5, "not measured", **centre)
    panels[0].plot(time, np.degrees(simulated), **SIMULATED)


def decorate(axes: list[Axes], row: int, used: int, *, last: bool) -> None:
    """Labels once per row and column; no empty frames."""
    axes[0].set_ylabel(LABELS[row])
    for number, panel in enumerate(axes):
        panel.set_visible(number < used)
        panel.yaxis.set_major_locator(MaxNLocator(4 if row % 2 else 5))
        panel.xaxis.set_major_locator(MaxNLocator(5))
        panel.tick_params(labelleft=number == 0)
        if last:
            panel.set_xlabel("time [s]")
