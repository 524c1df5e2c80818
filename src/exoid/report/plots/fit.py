"""A fit as one figure for print: its motion, what determined its numbers, and how firmly."""

from io import BytesIO
from math import ceil
from pathlib import Path
from textwrap import fill
from typing import Any

from matplotlib import rc_context
from matplotlib.figure import Figure, SubFigure
from matplotlib.layout_engine import ConstrainedLayoutEngine

from exoid.files.replacing import replacing
from exoid.fitting.errors.profile import Profile
from exoid.fitting.result.fit_result import FitResult
from exoid.report.pictures.determined import shares_of
from exoid.report.pictures.motion import chosen_segments, motion_of
from exoid.report.pictures.profiles import profile_of, rows_of
from exoid.report.pictures.search import (
    PAIRS,
    costs_of,
    differ,
    ended,
    family_of,
    missing,
    pairs_of,
)
from exoid.report.plots.arrange import draw_bands, draw_rows, head
from exoid.report.plots.draw import draw, name_all
from exoid.report.plots.style import TEXT
from exoid.report.words.astray import WARNING

FORMATS = ("pdf", "svg", "png")
RESOLUTION = 160  # dots per inch of a png
ACROSS = 5  # segments side by side
NARROWEST = 10.5  # inches
SEGMENT = 2.6  # inches that a segment needs across
MOTION = 4.8  # inches that its four panels need
SOURCES = 3.3  # inches
PROFILES = 2.3  # inches per row
WORDS = 30  # letters across a panel
BANNER: dict[str, Any] = {"fontweight": "bold", "color": "tab:red"}
EMBEDDED: dict[Any, Any] = {"pdf.fonttype": 42, "svg.fonttype": "path"}


def plot_fit(result: FitResult, profiles: dict[str, Profile] | None = None) -> Figure:
    """Angle and angular velocity with their residuals per segment; below, what determined the
    numbers, and how much worse the fit gets where one of them is held elsewhere: of a fit that does
    not follow its recording that says nothing, and the figure shows the motion and says so.

    >>> exoid.plot_fit(exoid.fit("drops.csv")).savefig("fit.png")
    """
    segments = chosen_segments(result)
    gyro = any(each.angular_velocity is not None for each in segments)
    known = profiles if profiles and result.follows else {}
    bands = ceil(len(segments) / ACROSS)
    across = ceil(len(segments) / bands)
    curves = [[profile_of(each) for each in row] for row in rows_of(known)]
    heights = [MOTION * bands, *([SOURCES] if result.follows else [])]
    heights += [PROFILES * len(curves) + 0.5] if curves else []
    with rc_context(TEXT):
        size = (max(NARROWEST, SEGMENT * across), sum(heights))
        figure = Figure(figsize=size, layout=ConstrainedLayoutEngine(w_pad=0.07, h_pad=0.05))
        parts = figure.subfigures(len(heights), 1, squeeze=False, height_ratios=heights)[:, 0]
        columns = [motion_of(each)[: 4 if gyro else 3] for each in segments]
        draw_bands(parts[0], columns, across)
        if result.follows:
            draw_sources(parts[1], result)
        if curves:
            head(parts[2], "How far each quantity can move before the fit gets worse")
            draw_rows(parts[2], curves, 5)
        if title := title_of(result, len(segments)):
            figure.suptitle(title, **({} if result.follows else BANNER))
    return figure


def title_of(result: FitResult, shown: int) -> str:
    """That the fit does not follow its recording; how many segments are not shown."""
    some = f"The {shown} of {len(result.segments)} segments with the largest RMSE"
    lines = [
        *([] if result.follows else [WARNING]),
        *([some] if shown < len(result.segments) else []),
    ]
    return "\n".join(lines)


def draw_sources(figure: SubFigure, result: FitResult) -> None:
    """Shares (and costs, where starts ended at different ones), then the pairs that trade off."""
    head(figure, "What determined the numbers")
    report = result.multistart
    told = [costs_of(report)] if differ(report) else []
    told.append(shares_of(result))
    families = [family_of(result, pair) for pair in pairs_of(result)]
    places = list(figure.subplots(1, len(told) + len(PAIRS)))
    for axes, panel in zip(places, [*told, *families], strict=False):
        draw(axes, panel)
    places[0].set_title(ended(report), loc="left")
    places[len(told) - 1].tick_params(axis="y", length=0)
    empty = places[len(told) + len(families) :]
    for axes in empty:
        axes.set_axis_off()
    for axes in empty[:1]:
        lines = [line for words in missing(result) for line in words.split("\n")]
        wrapped = "\n".join(fill(line, WORDS * len(empty)) for line in lines)
        axes.text(0, 1, wrapped, va="top").set_in_layout(False)
    name_all(figure, places, "lower", 6)


def save_figure(figure: Figure, path: str | Path) -> None:
    """Writes a pdf, svg or png by the name's suffix, fonts embedded, in full or not at all."""
    kind = Path(path).suffix.lower().lstrip(".")
    if kind not in FORMATS:
        raise ValueError(f"{path}: a figure is saved to a name that ends in .pdf, .svg or .png.")
    content = BytesIO()  # a pipe cannot go back in what was written, as these formats do
    with rc_context(EMBEDDED):
        figure.savefig(content, format=kind, dpi=RESOLUTION)
    with replacing(path) as part:
        part.write_bytes(content.getvalue())
