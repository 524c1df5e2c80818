"""The pendulum test as one figure: every drop with its measures marked on the curves."""

from math import ceil
from typing import Any

import numpy as np
from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine

from exoid.pendulum.drops import Drop, PendulumTest
from exoid.recordings.landmarks.measure import Mark
from exoid.recordings.landmarks.rest import BAND
from exoid.recordings.landmarks.track import HALF
from exoid.report.plots.style import TEXT, entries
from exoid.report.words.typeset import mathtext

ACROSS = 3  # drops side by side
SHOWN = 12  # drops; the first ones
WIDE = 3.6  # inches of a drop
NARROWEST = 6.4  # inches, in which the legend finds room
HIGH = 0.1  # of an amplitude from its top, where its name stands clear of the curve
BELOW = 8.0  # deg under the curve, where the period is drawn
TALL = 5.6  # inches of its three panels
CURVE: dict[str, Any] = {"color": "#56B4E9", "linewidth": 2.0, "label": "measured angle"}
SLOPE: dict[str, Any] = {"color": "black", "linewidth": 0.9, "label": "its derivatives"}
RESTING: dict[str, Any] = {
    "color": "#009E73",
    "linewidth": 1.0,
    "linestyle": (0, (4, 2)),
    "label": "plateau angle",
}
AT_REST: dict[str, Any] = {"color": "0.88", "linewidth": 0, "label": "at rest (±2 deg)"}
FLEXION: dict[str, Any] = {"color": "#D55E00", "marker": "v", "label": "peak of flexion"}
EXTENSION: dict[str, Any] = {"color": "#0072B2", "marker": "^", "label": "peak of extension"}
RELEASE: dict[str, Any] = {"color": "black", "marker": "o", "label": "release"}
CAME: dict[str, Any] = {"color": "#009E73", "marker": "s", "label": "at rest from here"}
DOT: dict[str, Any] = {"linestyle": "", "markersize": 5, "markeredgewidth": 0.4}
SPAN: dict[str, Any] = {"arrowstyle": "<->", "color": "0.25", "linewidth": 0.8}
LABELS = ("angle [deg]", "angular velocity\n[deg/s]", "angular acceleration\n[deg/s$^2$]")


def plot_drops(test: PendulumTest) -> Figure:
    """Angle, angular velocity and angular acceleration of every drop over time, with release,
    peaks, plateau and rest; spans name the amplitudes A1 and A0, the period T and the time to rest.

    **Raises** `ValueError` where no segment could be read.
    """
    readable = [each for each in test.drops if each.curve is not None]
    drops = readable[:SHOWN]
    if not drops:
        raise ValueError("no segment could be read as a drop: there is nothing to draw.")
    bands = ceil(len(drops) / ACROSS)
    across = ceil(len(drops) / bands)
    with rc_context(TEXT):
        figure = Figure(
            figsize=(max(WIDE * across, NARROWEST), TALL * bands + 0.5),
            layout=ConstrainedLayoutEngine(w_pad=0.05, h_pad=0.05),
        )
        panels: list[Axes] = []
        for number, part in enumerate(figure.subfigures(bands, 1, squeeze=False)[:, 0]):
            rows = part.subplots(
                3, across, sharex="col", sharey="row", squeeze=False, height_ratios=[2, 1, 1]
            )
            each = drops[number * across : (number + 1) * across]
            for column, drop in enumerate(each):
                draw_drop(drop, list(rows[:, column]))
                panels += list(rows[:, column])
            for row, axes in enumerate(rows):
                axes[0].set_ylabel(LABELS[row])
                for empty in axes[len(each) :]:
                    empty.set_visible(False)
            part.align_ylabels(rows[:, 0])
        found = entries(panels)
        figure.legend(
            found.values(), found.keys(), loc="outside upper center", ncols=4, frameon=False
        )
        if len(drops) < len(readable):
            figure.suptitle(f"The first {len(drops)} of {len(readable)} drops")
    return figure


def draw_drop(drop: Drop, panels: list[Axes]) -> None:
    """The three curves of one drop and what was read off them."""
    assert drop.curve is not None  # only what was read is drawn
    angle, velocity, acceleration = panels
    track, curve = drop.segment, drop.curve
    raw = track.angle if track.raw_angle is None else track.raw_angle
    assert raw is not None  # a Segment has one or the other
    angle.plot(track.time, np.degrees(raw), **CURVE)
    velocity.plot(curve.time, np.degrees(curve.velocity), **SLOPE)
    sure = curve.time < curve.time[-1] - HALF  # nearer to the end a second derivative is all noise
    acceleration.plot(curve.time[sure], np.degrees(curve.acceleration[sure]), **SLOPE)
    draw_rest(drop, angle)
    draw_swings(drop, angle)
    draw_spans(drop, angle)
    for axes, kind in ((velocity, "velocity"), (acceleration, "acceleration")):
        axes.axhline(0, color="0.7", linewidth=0.6, zorder=0)
        dots(axes, marks(drop, f"peak_flexion_{kind}"), FLEXION)
        dots(axes, marks(drop, f"peak_extension_{kind}"), EXTENSION)
    loaded = f", {drop.added_mass:.3g} kg added" if drop.added_mass else ""
    angle.set_title(f"segment {drop.name}{loaded}{index(drop)}", loc="left")
    acceleration.set_xlabel("time [s]")


def index(drop: Drop) -> str:
    """The relaxation index, for the title."""
    found = drop.measures["relaxation_index"].value
    return "\nno relaxation index" if found is None else f"\nrelaxation index {found:.3f}"


def draw_rest(drop: Drop, axes: Axes) -> None:
    """The resting angle with its band, and when the leg came to it."""
    rest = marks(drop, "plateau_angle")
    if not rest:
        return
    band = np.degrees([rest[0].value - BAND, rest[0].value + BAND])
    axes.axhspan(*band.tolist(), zorder=0, **AT_REST)
    axes.axhline(float(np.degrees(rest[0].value)), zorder=1, **RESTING)
    dots(axes, marks(drop, "time_to_rest")[1:], CAME)


def draw_swings(drop: Drop, axes: Axes) -> None:
    """Release and turning points, as far as a measure rests on them."""
    flexions: set[Mark] = set(marks(drop, "number_of_oscillations")) | set(marks(drop, "period"))
    extensions: set[Mark] = set()
    for name in drop.measures:
        if name.startswith("logarithmic_decrement"):
            flexions |= set(marks(drop, name)[1::2])
            extensions |= set(marks(drop, name)[0::2])
    released = marks(drop, "start_angle")
    flexions |= set(marks(drop, "first_flexion_amplitude")[1:])
    dots(axes, flexions, FLEXION)
    dots(axes, extensions - set(released), EXTENSION)
    dots(axes, released, RELEASE)


def draw_spans(drop: Drop, axes: Axes) -> None:
    """A1 and A0 as heights, T and the time to rest as lengths."""
    first, plateau = marks(drop, "first_flexion_amplitude"), marks(drop, "plateau_amplitude")
    if first:
        height(axes, first[1].time, first, mathtext("A1"))
    if plateau:
        height(axes, plateau[1].time, plateau, mathtext("A0"))
    period, rest = marks(drop, "period"), marks(drop, "time_to_rest")
    if period:
        count = round((period[1].time - period[0].time) / (drop.measures["period"].value or 1.0))
        low = float(np.degrees(period[0].value)) - BELOW
        length(
            axes,
            (period[0].time, period[1].time),
            low,
            mathtext(f"{count} T" if count > 1 else "T"),
        )
    if rest:
        high = float(np.degrees(rest[0].value)) + BELOW
        length(axes, (rest[0].time, rest[1].time), high, "time to rest")


def height(axes: Axes, time: float, ends: tuple[Mark, ...], name: str) -> None:
    """An arrow between two angles, named near its top."""
    top, bottom = (float(np.degrees(each.value)) for each in ends[:2])
    axes.annotate("", (time, top), (time, bottom), arrowprops=SPAN)
    axes.plot([ends[0].time, time], [top, top], color="0.6", linewidth=0.6, zorder=0)
    middle = (time, top - HIGH * (top - bottom))
    axes.annotate(name, middle, xytext=(3, 0), textcoords="offset points", va="center")


def length(axes: Axes, ends: tuple[float, float], angle: float, name: str) -> None:
    """An arrow between two times, named above its middle; the view makes room for both."""
    axes.annotate("", (ends[0], angle), (ends[1], angle), arrowprops=SPAN)
    axes.update_datalim([(ends[0], angle - BELOW / 2), (ends[1], angle + BELOW)])
    middle = (sum(ends) / 2, angle)
    axes.annotate(name, middle, xytext=(0, 2), textcoords="offset points", ha="center")


def dots(axes: Axes, places, style: dict[str, Any]) -> None:
    """Marks on a curve; nothing where there are none."""
    if places:
        time, value = zip(*((each.time, np.degrees(each.value)) for each in places), strict=True)
        axes.plot(time, value, **DOT | style)


def marks(drop: Drop, name: str) -> tuple[Mark, ...]:
    """Where a measure was read; none where it was not."""
    return drop.measures[name].marks
