"""What every cause leaves unexplained."""

from math import log10
from typing import Any

from plotly.graph_objects import Bar

from exoid.mismatch.answer.diagnosis import Diagnosis
from exoid.report.figures.figure import Figure
from exoid.report.figures.style import FOUND_LINE, GREY, blank
from exoid.report.parts.causes import LEAST, Cause, causes

ROW, REST = 34, 80  # pixels for each cause, and for the axis
OTHERS = "#e3e3e3"
FINE = 20.0  # times the noise, up to which there is room for ticks between powers of ten
TICKS = (0.5, 1, 2, 5, 10, 20)
LARGE = 1000.0  # times the noise, from which on three digits would be a power of ten
ROOM = 1.25  # times the longest bar, for the number beside it


def draw_bars(found: Diagnosis) -> Figure:
    """The baseline first, then the causes that leave least; on a logarithmic axis."""
    rows = causes(found)
    drawing = blank(ROW * len(rows) + REST, showlegend=False, margin={"t": 12})
    drawing.add_trace(
        Bar(
            x=[max(row.left, LEAST) for row in rows],
            y=[row.name.replace("\n", "<br>") for row in rows],
            orientation="h",
            text=[in_times(row.left) for row in rows],
            textposition="outside",
            cliponaxis=False,
            marker=look(rows),
            hovertemplate="leaves %{x:.3g} times the noise's mean square<extra></extra>",
        )
    )
    drawing.add_vline(1, line={"color": "#000000", "width": 1.5, "dash": "5px,3px"})
    drawing.update_yaxes(autorange="reversed", ticks="", showgrid=False)
    most = max(row.left for row in rows)
    drawing.update_xaxes(
        type="log",
        title_text="mean square left / noise",
        tickvals=TICKS if most < FINE else None,
        dtick=None if most < FINE else 1,
        range=[log10(LEAST), log10(LEAST) + ROOM * log10(most / LEAST)],
    )
    least = min(rows[1:], key=lambda row: row.left, default=rows[0])
    return Figure(
        "causes",
        "Bars of what every cause leaves unexplained, as mean square over the noise. Eq. 9 alone "
        f"leaves {in_times(rows[0].left)}; {' '.join(least.name.split())} leaves "
        f"{in_times(least.left)}.",
        "How much each explanation leaves, on a logarithmic scale: the dashed line is the noise "
        "itself, nothing is left below it. Blue without stripes: what was chosen.",
        drawing,
    )


def look(rows: list[Cause]) -> dict[str, Any]:
    """What was chosen is blue, the rest striped."""
    shapes = ["" if row.chosen else "/" for row in rows]
    return {
        "color": [FOUND_LINE["color"] if row.chosen else OTHERS for row in rows],
        "pattern": {"shape": shapes, "fgcolor": GREY, "size": 7},
        "line": {"color": GREY, "width": 0.5},
    }


def in_times(left: float) -> str:
    """With three digits, and never as a power of ten."""
    return f"{left:.3g}" if left < LARGE else f"{left:.0f}"
