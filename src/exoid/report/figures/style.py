"""How the figures of the report look: the colours of those for print, drawn by plotly."""

from typing import Any

import numpy as np
from jaxtyping import Float
from plotly.graph_objects import Figure as Drawing
from plotly.graph_objects import Scatter

from exoid.report.plots.diagnosis import MARKED
from exoid.report.plots.style import MEASURED, MEMBER, RESIDUAL, SHARE

MOST = 1500  # samples of a curve; more are not seen, and make the page heavy
INK, FAINT, PAPER = "#222222", "#e3e3e3", "#ffffff"
GREY = "#595959"
BAND: dict[str, Any] = {"fillcolor": "rgba(0,0,0,0.13)", "line_width": 0, "layer": "below"}

STRONGEST: dict[str, Any] = {
    "fillcolor": MARKED["color"],
    "opacity": MARKED["alpha"],
    "line_width": 0,
    "layer": "below",
}

MEASURED_LINE = {"color": MEASURED["color"], "width": 4}
SIMULATED_LINE = {"color": "#000000", "width": 1.4, "dash": "5px,2px"}
RESIDUAL_LINE = {"color": RESIDUAL["color"], "width": 1.2}
FOUND_LINE = {"color": MEMBER["color"], "width": 1.8, "dash": "6px,3px"}
PLAIN_LINE = {"color": GREY, "width": 1.2}
HATCH = {"fgcolor": "#000000", "fillmode": "overlay", "size": 7}
SHARE_LOOK: dict[str, dict[str, Any]] = {
    source: {
        "color": look["facecolor"],
        "pattern": {"shape": shape, **HATCH},
    }
    for (source, look), shape in zip(SHARE.items(), ("", "/", "x"), strict=True)
}

AXIS: dict[str, Any] = {
    "gridcolor": FAINT,
    "linecolor": GREY,
    "zeroline": False,
    "ticks": "outside",
    "ticklen": 4,
    "tickcolor": GREY,
    "automargin": True,
    "title": {"standoff": 6},
    "ticklabelstandoff": 3,
}
TEMPLATE: dict[str, Any] = {
    "data": {"scatter": [{"line": {"simplify": False}}]},
    "layout": {
        "font": {"family": "system-ui, sans-serif", "size": 12, "color": INK},
        "paper_bgcolor": PAPER,
        "plot_bgcolor": PAPER,
        "margin": {"l": 8, "r": 16, "t": 38, "b": 8},
        "showlegend": True,
        "legend": {
            "orientation": "h",
            "x": 0,
            "y": 1,
            "yref": "container",
            "yanchor": "top",
            "traceorder": "normal",
        },
        "hoverlabel": {"bgcolor": PAPER, "font": {"color": INK}},
        "xaxis": AXIS,
        "yaxis": AXIS,
    },
}

Samples = Float[np.ndarray, " sample"]


def blank(height: int, **layout: Any) -> Drawing:
    """A drawing with nothing in it yet, so many pixels high."""
    return Drawing(layout={"template": TEMPLATE, "height": height, **layout})


def thinned(samples: Samples) -> slice:
    """Every so manieth sample, where there are too many to see."""
    return slice(None, None, -(-samples.size // MOST))


def curve(drawing: Drawing, time: Samples, samples: Samples, **look: Any) -> None:
    """Samples over time [s] as a line, thinned where there are too many."""
    kept = thinned(time)
    drawing.add_trace(Scatter(x=compact(time[kept]), y=compact(samples[kept]), **look))


def compact(samples: Any) -> Float[np.ndarray, "*any"]:
    """With as many digits as a drawing needs."""
    return np.asarray(samples, dtype=np.float32)


def stacked(heights: list[float], gap: float) -> list[tuple[float, float]]:
    """The places of panels above each other, of these relative heights, in parts of the whole."""
    free = 1 - gap * (len(heights) - 1)
    sizes = [free * height / sum(heights) for height in heights]
    tops = [1 - sum(sizes[:at]) - gap * at for at in range(len(sizes))]
    return [(max(top - size, 0.0), min(top, 1.0)) for top, size in zip(tops, sizes, strict=True)]
