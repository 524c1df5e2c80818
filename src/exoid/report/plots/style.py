"""How a figure for print looks: letters, spines, and each role's look as matplotlib has it."""

from typing import Any

from exoid.report.pictures.role import BLACK, Look

MARKERS = {"circle": "o", "diamond": "D", "square": "s", "down": "v", "up": "^", "limit": "|"}
HATCHES = {"": "", "/": "/////", "x": "xxxx"}
TEXT: dict[Any, Any] = {
    "font.size": 8,
    "axes.titlesize": 8,
    "axes.labelsize": 8,
    "xtick.labelsize": 7,
    "ytick.labelsize": 7,
    "legend.fontsize": 8,
    "figure.titlesize": 9,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.unicode_minus": True,
    "hatch.linewidth": 0.6,
}


def line(look: Look) -> dict[str, Any]:
    """Of a curve or a rule."""
    dash = "-" if look.dash is None else (0, look.dash)
    return {"color": look.colour, "linewidth": look.width, "linestyle": dash}


def dots(look: Look) -> dict[str, Any]:
    """Of its markers."""
    return {
        "marker": MARKERS.get(look.marker, ""),
        "markersize": look.size,
        "markerfacecolor": "none" if look.hollow else look.colour,
        "markeredgewidth": 1.0 if look.hollow else 0.4,
        "alpha": look.opacity,
    }


def area(look: Look) -> dict[str, Any]:
    """Of a band."""
    return {"color": look.colour, "alpha": look.opacity, "linewidth": 0}


def bar(look: Look) -> dict[str, Any]:
    """Of a bar, which has an edge."""
    edge = {"edgecolor": BLACK, "linewidth": 0.5}
    return {"facecolor": look.colour, "hatch": HATCHES[look.hatch], **edge}
