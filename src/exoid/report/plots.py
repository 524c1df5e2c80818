"""A fit as one figure for print: measured against simulated, and where the starts ended."""

from math import ceil
from pathlib import Path
from textwrap import fill
from typing import Any

import numpy as np
from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.figure import Figure, SubFigure
from matplotlib.layout_engine import ConstrainedLayoutEngine
from matplotlib.ticker import MaxNLocator

from exoid.fit.result import FitResult, SegmentFit
from exoid.report.fit_json import replacing
from exoid.report.fit_table import in_degrees, on_bound

FORMATS = ("pdf", "svg", "png")
NO_REASON = "the recording does not tell"
RESOLUTION = 160  # dots per inch of a png
ACROSS = 5  # panels side by side
SHOWN = 15  # segments; of more, those that fit worst
PAIRS = (("mass", "com_distance"), ("inertia", "stiffness"), ("inertia", "damping"))
LINEAR = 10.0  # cost over best cost, up to which a linear axis shows all starts
BAND = 4.8  # inches that four panels need

# Okabe and Ito's colours, told apart with every kind of colour vision; widths and dashes for print.
MEASURED = {"color": "#56B4E9", "linewidth": 2.4, "label": "measured"}
SIMULATED = {"color": "black", "linewidth": 0.9, "linestyle": (0, (4, 1.5)), "label": "simulated"}
RESIDUAL = {"color": "#D55E00", "linewidth": 0.7, "label": "residual (simulated - measured)"}
NOISE = {"color": "0.8", "linewidth": 0, "label": "noise of the sensor (±2 sd)"}
MEMBER = {"color": "#0072B2", "marker": "o", "markersize": 3, "linestyle": "", "alpha": 0.5}
CHOSEN = {
    "color": "#D55E00",
    "marker": "D",
    "markersize": 5,
    "linestyle": "",
    "capsize": 2,
    "label": "chosen ± standard error",
}
EXPECTED = {
    "color": "0.35",
    "marker": "s",
    "markersize": 7,
    "markerfacecolor": "none",
    "linestyle": "",
    "capsize": 4,
    "label": "expected ± standard deviation",
}
TEXT: dict[Any, Any] = {
    "font.size": 8,
    "axes.titlesize": 8,
    "axes.labelsize": 8,
    "xtick.labelsize": 7,
    "ytick.labelsize": 7,
    "legend.fontsize": 8,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.unicode_minus": True,
}
LABELS = ("angle\n[deg]", "residual\n[deg]", "angular velocity\n[deg/s]", "residual\n[deg/s]")
EMBEDDED: dict[Any, Any] = {"pdf.fonttype": 42, "svg.fonttype": "path"}


def plot_fit(result: FitResult) -> Figure:
    """Angle and angular velocity with their residuals per segment; below, the multi-start."""
    segments = chosen_segments(result)
    bands = ceil(len(segments) / ACROSS)
    across = ceil(len(segments) / bands)
    with rc_context(TEXT):
        size = (max(9.0, 2.6 * across), BAND * bands + 2.9)
        figure = Figure(figsize=size, layout=ConstrainedLayoutEngine(w_pad=0.07, h_pad=0.05))
        parts = figure.subfigures(2, 1, squeeze=False, height_ratios=[BAND * bands, 2.7])
        motion, starts = parts[:, 0]
        draw_motion(motion, segments, across)
        draw_multistart(starts, result)
        if len(segments) < len(result.segments):
            figure.suptitle(
                f"The {len(segments)} of {len(result.segments)} segments with the largest RMSE"
            )
    return figure


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
    handles, labels = entries([axes for same in rows for axes in same])
    once = dict(zip(labels, handles, strict=True))
    figure.legend(once.values(), once.keys(), loc="outside upper center", ncols=4, frameon=False)


def share_scale(panels: list[Axes]) -> None:
    """One vertical scale for all panels that hold data."""
    filled = [axes for axes in panels if axes.lines]
    lower, upper = zip(*(axes.get_ylim() for axes in filled), strict=True)
    for axes in filled:
        axes.set_ylim(min(lower), max(upper))


def entries(panels: list[Axes]) -> tuple[list[Any], list[str]]:
    """What a legend can name in these panels."""
    each = [axes.get_legend_handles_labels() for axes in panels]
    return [one for handles, _ in each for one in handles], [
        one for _, labels in each for one in labels
    ]


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


def draw_multistart(figure: SubFigure, result: FitResult) -> None:
    """The sorted costs, and the sets that fit as well as the chosen one."""
    pairs = [pair for pair in PAIRS if drawable(result, *pair)]
    panels = figure.subplots(1, 4)
    draw_costs(panels[0], result)
    for axes, pair in zip(panels[1:], pairs, strict=False):
        draw_family(axes, result, *pair)
    for axes in panels[1 + len(pairs) :]:
        axes.set_axis_off()
    if len(pairs) < len(PAIRS):
        why = panels[1 + len(pairs)].text(0, 1, missing(result, pairs), va="top")
        why.set_in_layout(False)
    handles, labels = entries(list(panels[1:]))
    first = dict(zip(labels, handles, strict=True))
    if first:
        figure.legend(
            first.values(), first.keys(), loc="outside lower center", ncols=4, frameon=False
        )


def draw_costs(axes: Axes, result: FitResult) -> None:
    """Cost over best cost, sorted: steps are distinct minima."""
    report = result.multistart
    costs = np.sort(report.loss[np.isfinite(report.loss)])
    if costs.size and costs[0] > 0:
        ratio = costs / costs[0]
        axes.plot(np.arange(1, costs.size + 1), ratio, **MEMBER)
        if ratio[-1] > LINEAR:
            axes.set_yscale("log")
        else:
            axes.set_ylim(0, max(2.0, 1.1 * ratio[-1]))
    axes.xaxis.set_major_locator(MaxNLocator(5, integer=True))
    axes.set_xlim(0, report.starts + 1)
    axes.set_xlabel("start, sorted [-]")
    axes.set_ylabel("cost / best cost [-]")
    axes.set_title(
        f"{report.at_best} of {report.starts} starts at the best cost,\n"
        f"{report.starts - report.succeeded} failed",
        loc="left",
    )


def drawable(result: FitResult, across: str, up: str) -> bool:
    """Whether there is a set or a value of this pair."""
    known = all(result.parameters[name].value is not None for name in (across, up))
    return known or {across, up} <= result.multistart.members.keys()


def draw_family(axes: Axes, result: FitResult, across: str, up: str) -> None:
    """Sets that fit equally well, the chosen one with its errors, and what was expected."""
    members, both = result.multistart.members, (result.parameters[across], result.parameters[up])
    if {across, up} <= members.keys():
        axes.plot(members[across], members[up], **MEMBER, label="fits equally well")
    expected = [(each.expected, each.expected_deviation) for each in both]
    chosen = [(on_bound(each), each.standard_error) for each in both]
    mark(axes, expected, EXPECTED)
    mark(axes, chosen, CHOSEN)
    axes.set_xlabel(f"{across} {both[0].symbol} [{both[0].unit}]")
    axes.set_ylabel(f"{up} {both[1].symbol} [{both[1].unit}]")
    axes.set_title(f"{both[0].symbol} and {both[1].symbol}", loc="left")
    axes.xaxis.set_major_locator(MaxNLocator(5))


def mark(axes: Axes, both: list[tuple[float | None, float | None]], style: dict[str, Any]) -> None:
    """One point with its error bars, where both coordinates are known."""
    (x, dx), (y, dy) = both
    if x is not None and y is not None:
        axes.errorbar(x, y, xerr=dx, yerr=dy, zorder=3, elinewidth=1, **style)


def missing(result: FitResult, pairs: list[tuple[str, str]]) -> str:
    """What is not shown, and why."""
    lost = {name for pair in PAIRS if pair not in pairs for name in pair}
    unknown = {name: each for name, each in result.parameters.items() if name in lost}
    reasons: dict[str, list[str]] = {}
    for name, each in unknown.items():
        if each.value is None:
            reasons.setdefault(each.reason or NO_REASON, []).append(name)
    wide = 30 * (len(PAIRS) - len(pairs))
    lines = [f"{', '.join(names)} not determined:\n{reason}" for reason, names in reasons.items()]
    return "\n".join(fill(line, wide) for text in lines for line in text.split("\n"))


def save_figure(figure: Figure, path: str | Path) -> None:
    """Writes a pdf, svg or png by the name's suffix, fonts embedded, in full or not at all."""
    kind = Path(path).suffix.lower().lstrip(".")
    if kind not in FORMATS:
        raise ValueError(f"{path}: a figure is saved to a name that ends in .pdf, .svg or .png.")
    with replacing(path) as part, rc_context(EMBEDDED):
        figure.savefig(part, format=kind, dpi=RESOLUTION)
