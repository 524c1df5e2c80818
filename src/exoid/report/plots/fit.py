"""A fit as one figure for print: its motion, what determined its numbers, and how firmly."""

from math import ceil
from pathlib import Path
from typing import Any

from matplotlib import rc_context
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine

from exoid.fitting.errors.profile import Profile
from exoid.fitting.result.fit_result import FitResult
from exoid.report.document.replacing import replacing
from exoid.report.plots.motion import chosen_segments, draw_motion
from exoid.report.plots.profiles import draw_profiles, rows_of
from exoid.report.plots.sources import draw_sources
from exoid.report.plots.style import TEXT

FORMATS = ("pdf", "svg", "png")
RESOLUTION = 160  # dots per inch of a png
ACROSS = 5  # segments side by side
NARROWEST = 10.5  # inches
SEGMENT = 2.6  # inches that a segment needs across
MOTION = 4.8  # inches that its four panels need
SOURCES = 3.3  # inches
PROFILES = 2.3  # inches per row
EMBEDDED: dict[Any, Any] = {"pdf.fonttype": 42, "svg.fonttype": "path"}


def plot_fit(result: FitResult, profiles: dict[str, Profile] | None = None) -> Figure:
    """Angle and angular velocity with their residuals per segment; below, what determined the
    numbers, and how much worse the fit gets where one of them is held elsewhere.
    """
    segments = chosen_segments(result)
    bands = ceil(len(segments) / ACROSS)
    across = ceil(len(segments) / bands)
    curves = rows_of(profiles or {})
    heights = [MOTION * bands, SOURCES, *([PROFILES * len(curves) + 0.5] if curves else [])]
    with rc_context(TEXT):
        size = (max(NARROWEST, SEGMENT * across), sum(heights))
        figure = Figure(figsize=size, layout=ConstrainedLayoutEngine(w_pad=0.07, h_pad=0.05))
        parts = figure.subfigures(len(heights), 1, squeeze=False, height_ratios=heights)[:, 0]
        draw_motion(parts[0], segments, across)
        draw_sources(parts[1], result)
        if curves:
            draw_profiles(parts[2], curves)
        if len(segments) < len(result.segments):
            figure.suptitle(
                f"The {len(segments)} of {len(result.segments)} segments with the largest RMSE"
            )
    return figure


def save_figure(figure: Figure, path: str | Path) -> None:
    """Writes a pdf, svg or png by the name's suffix, fonts embedded, in full or not at all."""
    kind = Path(path).suffix.lower().lstrip(".")
    if kind not in FORMATS:
        raise ValueError(f"{path}: a figure is saved to a name that ends in .pdf, .svg or .png.")
    with replacing(path) as part, rc_context(EMBEDDED):
        figure.savefig(part, format=kind, dpi=RESOLUTION)
