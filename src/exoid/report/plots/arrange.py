"""Where panels stand on a figure: columns in bands, or beside each other."""

from collections.abc import Sequence
from math import ceil

from matplotlib.axes import Axes
from matplotlib.figure import SubFigure

from exoid.report.pictures.panel import Panel
from exoid.report.plots.draw import draw, name_all


def draw_bands(figure: SubFigure, columns: Sequence[Sequence[Panel]], across: int) -> None:
    """Columns of panels, so many to a band; each quantity on one scale throughout."""
    sizes = [panel.size for panel in columns[0]]
    parts = figure.subfigures(ceil(len(columns) / across), 1, squeeze=False)[:, 0]
    rows: list[list[Axes]] = [[] for _ in sizes]
    for number, part in enumerate(parts):
        each = columns[number * across : (number + 1) * across]
        grid = part.subplots(len(sizes), across, sharex="col", squeeze=False, height_ratios=sizes)
        for at, column in enumerate(grid.T):
            for row, axes in enumerate(column):
                axes.set_visible(at < len(each))
                if at < len(each):
                    draw(axes, each[at][row])
                    rows[row].append(axes)
        for axes in grid.flat:
            axes.set_ylabel(axes.get_ylabel().replace(" [", "\n["))
            axes.label_outer()
        part.align_ylabels(grid[:, 0])
    for same in rows:
        share_scale(same)
    name_all(figure, [axes for same in rows for axes in same], "upper")


def share_scale(panels: list[Axes]) -> None:
    """One vertical scale for all panels that hold data."""
    filled = [axes for axes in panels if axes.lines]
    lower, upper = zip(*(axes.get_ylim() for axes in filled), strict=True)
    for axes in filled:
        axes.set_ylim(min(lower), max(upper))


def draw_rows(figure: SubFigure, rows: Sequence[Sequence[Panel]], legend: int = 4) -> None:
    """Panels that share their vertical axis, row by row."""
    grid = figure.subplots(len(rows), max(map(len, rows)), sharey="row", squeeze=False)
    for panels, places in zip(rows, grid, strict=True):
        for axes, panel in zip(places, panels, strict=False):
            draw(axes, panel)
        for axes in places[1:]:
            axes.set_ylabel("")
            axes.tick_params(labelleft=False)
        for axes in places[len(panels) :]:
            axes.set_axis_off()
    name_all(figure, list(grid.flat), "lower", legend)


def head(figure: SubFigure, title: str) -> None:
    """What a row of panels is about."""
    figure.suptitle(title, x=0.008, ha="left", fontweight="bold")
