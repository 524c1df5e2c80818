"""A diagnosis as one figure: where they part, which cause explains it, before and after."""

from math import degrees
from typing import Any

import numpy as np
from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.figure import Figure, SubFigure
from matplotlib.layout_engine import ConstrainedLayoutEngine

from exoid.mismatch.answer.diagnosis import Diagnosis
from exoid.report.parts.causes import LEAST, causes
from exoid.report.plots.style import TEXT, head, name_all
from exoid.report.words.diagnosis import headline, titles
from exoid.report.words.text import in_degrees

SHOWN = 4  # segments
BEFORE: dict[str, Any] = {"color": "#D55E00", "linewidth": 0.8, "label": "without it, held out"}
AFTER: dict[str, Any] = {"color": "#0072B2", "linewidth": 0.8, "label": "with it, held out"}
TORQUE: dict[str, Any] = {"color": "0.3", "linewidth": 0.8, "label": "missing torque, measured"}
MODELLED: dict[str, Any] = {
    "color": "#0072B2",
    "linewidth": 1.2,
    "linestyle": (0, (4, 2)),
    "label": "by what was found",
}
BAND: dict[str, Any] = {"color": "0.75", "linewidth": 0, "label": "noise (±2 sd)"}
MARKED: dict[str, Any] = {"color": "#E69F00", "alpha": 0.35, "linewidth": 0, "label": "strongest"}
WIDE, TALL = 10.5, 9.4  # inches


def plot_diagnosis(found: Diagnosis) -> Figure:
    """Missing torque over time and over the phase plane; the causes by what they leave; the
    residual of every held-out segment without and with what was found.
    """
    with rc_context(TEXT):
        figure = Figure(
            figsize=(WIDE, TALL), layout=ConstrainedLayoutEngine(w_pad=0.07, h_pad=0.05)
        )
        parts = figure.subfigures(3, 1, squeeze=False, height_ratios=[1.0, 1.15, 1.0])[:, 0]
        draw_torque(parts[0], found)
        draw_causes(parts[1], found)
        draw_proof(parts[2], found)
        figure.suptitle(title(found), fontweight="bold")
    return figure


def title(found: Diagnosis) -> str:
    """The verdict, and what is missing where it has a name."""
    if found.verdict != "mismatch" or found.novel or not found.selected:
        return headline(found)
    return "Missing: " + " and ".join(titles(found))


def worst(found: Diagnosis) -> list[int]:
    """The segments with the largest missing torque, in their order."""
    size = [float(np.std(each.torque)) for each in found.location.missing]
    return sorted(np.argsort(size)[::-1][:SHOWN].tolist())


def draw_torque(figure: SubFigure, found: Diagnosis) -> None:
    head(figure, "Where they part: the torque that Eq. 9 lacks")
    numbers = worst(found)
    panels = figure.subplots(1, len(numbers), sharey=True, squeeze=False)[0]
    for axes, number in zip(panels, numbers, strict=True):
        each = found.location.missing[number]
        axes.axhspan(-2 * each.band, 2 * each.band, **BAND)
        for region in found.location.regions:
            if region.segment == each.segment:
                axes.axvspan(region.begin, region.end, **MARKED)
        axes.plot(each.time, each.torque, **TORQUE)
        if each.modelled is not None:
            axes.plot(each.time, each.modelled, **MODELLED)
        axes.set_title(f"segment {each.segment}")
        axes.set_xlabel("time [s]")
    panels[0].set_ylabel("missing torque [N m]")
    name_all(figure, list(panels), "outside lower center")


def draw_causes(figure: SubFigure, found: Diagnosis) -> None:
    plane, bars = figure.subplots(1, 2, width_ratios=[1.0, 1.2])
    plane.set_title("over the phase plane", loc="left", fontweight="bold")
    draw_plane(plane, found, figure)
    bars.set_title("what explains it", loc="left", fontweight="bold")
    draw_bars(bars, found)


def draw_plane(axes: Axes, found: Diagnosis, figure: SubFigure) -> None:
    """Angle across, speed up, torque as colour, clipped at its 98th percentile."""
    each = found.location.missing
    angle = np.degrees(np.concatenate([one.angle for one in each]))
    speed = np.degrees(np.concatenate([one.angular_velocity for one in each]))
    torque = np.concatenate([one.torque for one in each])
    most = float(np.quantile(np.abs(torque), 0.98)) or 1.0
    dots = axes.scatter(
        angle, speed, c=torque, s=3, cmap="PuOr", vmin=-most, vmax=most, rasterized=True
    )
    axes.set_xlabel("angle [deg]")
    axes.set_ylabel("angular velocity [deg/s]")
    axes.axhline(0, color="0.6", linewidth=0.6)
    figure.colorbar(dots, ax=axes, label="missing torque [N m]", shrink=0.9)


def draw_bars(axes: Axes, found: Diagnosis) -> None:
    """What every cause leaves, over the noise, on a logarithmic axis."""
    rows = causes(found)
    values = [max(row.left, LEAST) for row in rows]
    colours = ["#0072B2" if row.chosen else "0.7" for row in rows]
    bars = axes.barh(range(len(rows)), values, color=colours, edgecolor="0.4", linewidth=0.5)
    for bar, row in zip(bars, rows, strict=True):
        bar.set_hatch("" if row.chosen else "//")
    axes.set_yticks(range(len(rows)), [row.name for row in rows])
    axes.invert_yaxis()
    axes.set_xscale("log")
    axes.set_xlim(LEAST, max(20.0, 1.5 * max(values)))  # at least two ticks
    axes.xaxis.set_minor_formatter("")
    axes.axvline(1.0, color="black", linewidth=0.9, linestyle=(0, (4, 2)))
    axes.set_xlabel("mean square of what is left over the noise [1] (dashed: the noise itself)")


def draw_proof(figure: SubFigure, found: Diagnosis) -> None:
    before, after = found.proof.before, found.proof.after
    floor = in_degrees(found.proof.noise_floor)
    head(
        figure,
        f"On held-out data: angle RMSE {in_degrees(before.total)} deg before, "
        f"{in_degrees(after.total)} deg after, noise floor {floor} deg",
    )
    numbers = worst(found)
    shown = found.proof
    predictions = [(before, BEFORE), (after, AFTER)] if found.changed else [(before, BEFORE)]
    panels = figure.subplots(1, len(numbers), sharey=True, squeeze=False)[0]
    for axes, number in zip(panels, numbers, strict=True):
        time = shown.time[number]
        for one, style in predictions:
            held_out = one.counted[number]
            left = one.angle[number] - shown.angle[number]
            axes.plot(time[held_out], np.degrees(left[held_out]), **style)
        noise = 2 * degrees(found.proof.noise_floor)
        axes.axhspan(-noise, noise, **BAND)
        axes.set_title(f"segment {found.location.missing[number].segment}")
        axes.set_xlabel("time [s]")
    panels[0].set_ylabel("simulated - measured [deg]")
    name_all(figure, list(panels), "outside lower center")
