"""Draws a panel by matplotlib."""

from typing import Any

from matplotlib.axes import Axes
from matplotlib.axis import Axis as Edge
from matplotlib.colors import LinearSegmentedColormap
from matplotlib.figure import SubFigure
from matplotlib.ticker import AutoLocator, Locator, MaxNLocator, ScalarFormatter

from exoid.report.pictures.panel import (
    NEAR_TOP,
    Axis,
    Band,
    Bars,
    Cloud,
    Line,
    Mark,
    Note,
    Panel,
    Points,
    Rule,
    Span,
)
from exoid.report.pictures.role import BLACK, DIVERGING, INK
from exoid.report.plots.style import area, bar, dots, line
from exoid.report.words.typeset import with_mathtext

ARROW: dict[str, Any] = {"arrowstyle": "<->", "color": INK, "linewidth": 0.8}
COLOURS = LinearSegmentedColormap.from_list("diverging", DIVERGING)
LOW = 2.0  # size of a panel, below which it has room for few ticks
THICK = 0.75  # of a bar, of the room of its row


def draw(axes: Axes, panel: Panel) -> None:
    """All marks, then the axes with their labels and limits."""
    for mark in panel.marks:
        draw_mark(axes, mark)
    if panel.absent:
        axes.text(0.5, 0.5, panel.absent, ha="center", va="center", transform=axes.transAxes)
    if panel.of(Span):
        axes.margins(y=0.1)
    axes.set_title(with_mathtext(panel.title), loc="left")
    set_axis(axes, "x", panel.across, AutoLocator())
    set_axis(axes, "y", panel.up, MaxNLocator(4 if panel.size < LOW else 5))


def set_axis(axes: Axes, which: str, axis: Axis, places: Locator) -> None:
    """Few ticks, without matplotlib's own offset."""
    edge: Edge = getattr(axes, f"{which}axis")
    if axis.logarithmic:
        axes.set(**{f"{which}scale": "log"})
        edge.set_minor_formatter("")
    elif axis.ticks:
        at, names = zip(*axis.ticks, strict=True)
        edge.set_ticks(at, [with_mathtext(name) for name in names])
    else:
        edge.set_major_locator(places)
        edge.set_major_formatter(ScalarFormatter(useOffset=False))
    if axis.limits is not None:
        axes.set(**{f"{which}lim": axis.limits})
    edge.set_inverted(axis.reversed)
    edge.set_label_text(with_mathtext(axis.label))
    edge.set_visible(not axis.hidden)


def draw_mark(axes: Axes, mark: Mark) -> None:
    """One thing, named for the legend where its role has a name."""
    match mark:
        case Line(role, x, y):
            markers = dots(role.look) if role.look.marker else {}
            axes.plot(x, y, label=role.title, **line(role.look) | markers)
        case Points(role, x, y, dx, dy):
            look = dots(role.look) | {"color": role.look.colour, "linestyle": "", "zorder": 3}
            if dx is None and dy is None:
                axes.plot(x, y, label=role.title, **look)
            else:
                errors: dict[str, Any] = {"xerr": dx, "yerr": dy, "capsize": role.look.size / 2}
                axes.errorbar(x, y, label=role.title, elinewidth=1, **errors, **look)
        case Band(role, low, high, upright):
            span = axes.axvspan if upright else axes.axhspan
            span(low, high, label=role.title, zorder=0, **area(role.look))
        case Rule(role, at, upright):
            rule = axes.axvline if upright else axes.axhline
            rule(at, label=role.title, zorder=1, **line(role.look))
        case Bars(role, rows, lengths, begin, words):
            axes.barh(rows, lengths, THICK, begin, label=role.title, **bar(role.look))
            for row, length, word in zip(rows, lengths, words, strict=False):
                beside(axes, word, (length, row), (3, 0), va="center")
        case Cloud():
            draw_cloud(axes, mark)
        case Span():
            draw_span(axes, mark)
        case Note(words, across, height):
            side = "left" if across < 0.1 else "right" if across > 0.9 else "center"
            up = "bottom" if side == "center" else "center"
            room = axes.get_yaxis_transform()
            axes.text(across, height, words, ha=side, va=up, transform=room)


def draw_cloud(axes: Axes, cloud: Cloud) -> None:
    """Dots whose colour is their value, and what the colours mean."""
    limits = {"vmin": -cloud.most, "vmax": cloud.most}
    look: dict[str, Any] = {"s": 3, "cmap": COLOURS, "rasterized": True, **limits}
    shown = axes.scatter(cloud.x, cloud.y, c=cloud.value, **look)
    figure = axes.get_figure()
    assert figure is not None  # axes that are drawn on are of one
    figure.colorbar(shown, ax=axes, label=with_mathtext(cloud.label), shrink=0.9)


def draw_span(axes: Axes, span: Span) -> None:
    """An arrow with two heads; a height is named near its top, a length above its middle."""
    (x, low), (end, high) = span.begin, span.end
    axes.annotate("", span.end, span.begin, arrowprops=ARROW)
    axes.update_datalim([span.begin, span.end])  # the view makes room for an arrow, too
    name = with_mathtext(span.name)
    if x == end:
        beside(axes, name, (x, high - NEAR_TOP * (high - low)), (3, 0), va="center")
    else:
        beside(axes, name, ((x + end) / 2, low), (0, 2), ha="center")


def beside(axes: Axes, words: str, place: tuple[float, float], apart: Any, **options: Any) -> None:
    """Words so many points away from a place."""
    axes.annotate(words, place, xytext=apart, textcoords="offset points", color=BLACK, **options)


def entries(panels: list[Axes]) -> dict[str, Any]:
    """What a legend can name in these panels, each thing once."""
    found: dict[str, Any] = {}
    for axes in panels:
        handles, labels = axes.get_legend_handles_labels()
        found.update(zip(labels, handles, strict=True))
    return found


def name_all(figure: SubFigure, panels: list[Axes], where: str, across: int = 4) -> None:
    """One legend for all panels; none where there is nothing to name."""
    found = entries(panels)
    if found:
        look: dict[str, Any] = {"loc": f"outside {where} center", "frameon": False}
        figure.legend(found.values(), found.keys(), ncols=across, **look)
