"""How the figures of the report look: letters, grid, and each role's look as plotly has it."""

from typing import Any

from exoid.report.pictures.role import BLACK, GREY, Look

LARGER = 1.6  # pixels of a line for a point on paper
LARGER_MARK = 2.1  # and of a marker
FADED = 0.75  # of a band, beside lines that shine on a screen
INK, FAINT, PAPER = "#222222", "#e3e3e3", "#ffffff"
SYMBOLS = {
    "circle": "circle",
    "diamond": "diamond",
    "square": "square",
    "down": "triangle-down",
    "up": "triangle-up",
    "limit": "line-ns-open",
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


def line(look: Look) -> dict[str, Any]:
    """Of a curve or a rule."""
    width = LARGER * look.width
    dash = None if look.dash is None else ",".join(f"{width * part:.1f}px" for part in look.dash)
    return {"color": look.colour, "width": width, **({"dash": dash} if dash else {})}


def dots(look: Look) -> dict[str, Any]:
    """Of its markers."""
    hollow = {"symbol": f"{SYMBOLS[look.marker]}-open", "line": {"width": 2}}
    limit = {"line": {"width": 2}} if look.marker == "limit" else {}
    return {
        "color": look.colour,
        "symbol": SYMBOLS[look.marker],
        "size": LARGER_MARK * look.size,
        "opacity": look.opacity,
        **(hollow if look.hollow else limit),
    }


def area(look: Look) -> dict[str, Any]:
    """Of a band."""
    plain = {"fillcolor": look.colour, "opacity": FADED * look.opacity, "line": {"width": 0}}
    return {"type": "rect", "layer": "below", **plain}


def bar(look: Look) -> dict[str, Any]:
    """Of a bar, which has an edge."""
    hatch = {"shape": look.hatch, "fgcolor": BLACK, "fillmode": "overlay", "size": 7}
    return {"color": look.colour, "pattern": hatch, "line": {"color": BLACK, "width": 0.5}}
