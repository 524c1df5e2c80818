"""Draws what a panel shows by plotly."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from jaxtyping import Float
from plotly.graph_objects import Bar, Scatter
from plotly.graph_objects import Figure as Drawing

from exoid.report.figures.style import area, bar, dots, line
from exoid.report.pictures.panel import (
    Band,
    Bars,
    Cloud,
    Line,
    Mark,
    Note,
    Panel,
    Points,
    Region,
    Rule,
    Span,
    Values,
)
from exoid.report.pictures.role import DIVERGING, GREY, Role
from exoid.report.words.keyboard_text import tidy
from exoid.report.words.typeset import with_formulas

MOST = 1500  # samples of a curve; more are not seen, and make the page heavy
ARROW: dict[str, Any] = {"arrowside": "end+start", "arrowhead": 2, "arrowwidth": 1}
COLOURS = [(at / (len(DIVERGING) - 1), colour) for at, colour in enumerate(DIVERGING)]


@dataclass(frozen=True)
class Place:
    """The axes of a panel by plotly's names."""

    x: str
    y: str
    panel: Panel

    @property
    def axes(self) -> dict[str, str]:
        return {"xaxis": self.x, "yaxis": self.y}

    @property
    def references(self) -> dict[str, str]:
        return {"xref": self.x, "yref": self.y}

    def hover(self, *, across: bool) -> str:
        """What is told of a point; along a curve the time is told once for all of them."""
        x, y = (tidy(axis.unit.replace("-", "")) for axis in (self.panel.across, self.panel.up))
        if not across:
            return f"%{{y:.3f}} {y}"
        return f"%{{x:.4g}} {x}" + ("" if self.panel.up.hidden else f", %{{y:.4g}} {y}")


def draw_mark(drawing: Drawing, mark: Mark, place: Place, named: dict[str, bool]) -> None:
    """One thing; `named` are those that the legend has already."""
    match mark:
        case Line(role, x, y):
            kept = thinned(x)
            mode = "lines+markers" if role.look.marker else "lines"
            look = {"line": line(role.look), **legend(role, named)}
            if role.look.marker:
                look["marker"] = dots(role.look)
            samples = {"x": compact(x[kept]), "y": compact(y[kept])}
            told = place.hover(across=False)
            drawing.add_trace(
                Scatter(mode=mode, hovertemplate=told, **samples, **look, **place.axes)
            )
        case Points(role):
            drawing.add_trace(points(mark, place, named))
        case Band(role, low, high):
            ends = {"x0": 0, "x1": 1, "y0": low, "y1": high}
            shape(drawing, "rect", ends | area(role.look), f"{place.x} domain", place.y)
        case Region(role, begin, end):
            ends = {"x0": begin, "x1": end, "y0": 0, "y1": 1}
            shape(drawing, "rect", ends | area(role.look), place.x, f"{place.y} domain")
        case Rule(role, at, True):
            ends = {"x0": at, "x1": at, "y0": 0, "y1": 1, "line": line(role.look)}
            shape(drawing, "line", ends, place.x, f"{place.y} domain")
        case Rule(role, at):
            ends = {"x0": 0, "x1": 1, "y0": at, "y1": at, "line": line(role.look)}
            shape(drawing, "line", ends, f"{place.x} domain", place.y)
        case Bars():
            drawing.add_trace(bars(mark, place, named))
        case Cloud():
            drawing.add_trace(cloud(mark, place))
        case Span():
            draw_span(drawing, mark, place)
        case Note(words, across, height):
            side = "left" if across < 0.1 else "right" if across > 0.9 else "center"
            words = with_formulas(words)
            where = {"x": across, "y": height, "xref": f"{place.x} domain", "yref": place.y}
            drawing.add_annotation(text=words, xanchor=side, showarrow=False, **where)


def shape(drawing: Drawing, kind: str, look: dict[str, Any], x: str, y: str) -> None:
    """An area below all curves, or a line above all bars."""
    layer = "above" if kind == "line" else "below"
    drawing.add_shape(type=kind, layer=layer, xref=x, yref=y, **look)


def points(mark: Points, place: Place, named: dict[str, bool]) -> Scatter:
    """Markers with their errors."""
    look = mark.role.look
    errors = {
        f"error_{axis}": {"array": [error] * mark.x.size, "color": look.colour, "thickness": 1.6}
        for axis, error in (("x", mark.x_error), ("y", mark.y_error))
        if error
    }
    told, where = place.hover(across=True), {"x": compact(mark.x), "y": compact(mark.y)}
    more = {**errors, **legend(mark.role, named), **place.axes}
    return Scatter(mode="markers", marker=dots(look), hovertemplate=told, **where, **more)


def bars(mark: Bars, place: Place, named: dict[str, bool]) -> Bar:
    """Lying bars, from where they begin."""
    unit = place.panel.across.title
    return Bar(
        x=compact(mark.lengths),
        y=compact(mark.rows),
        base=None if mark.begin is None else compact(mark.begin),
        orientation="h",
        text=mark.words or None,
        textposition="outside" if mark.words else None,
        cliponaxis=False,
        marker=bar(mark.role.look),
        hovertemplate=f"{unit}: %{{x:.3g}}<extra></extra>",
        **legend(mark.role, named),
        **place.axes,
    )


def cloud(mark: Cloud, place: Place) -> Scatter:
    """Marks that point up where the value is positive, in its colour."""
    kept = thinned(mark.x)
    value = mark.value[kept]
    title, _, unit = mark.label.partition(" [")
    look = {
        "size": 7,
        "symbol": np.where(value > 0, "triangle-up", "triangle-down"),
        "color": compact(value),
        "colorscale": COLOURS,
        "cmin": -mark.most,
        "cmax": mark.most,
        "colorbar": {"title": {"text": unit.rstrip("]")}, "thickness": 12, "outlinewidth": 0},
    }
    told = f"{place.hover(across=True)}: {title} %{{marker.color:.3f}} {unit.rstrip(']')}"
    where = {"x": compact(mark.x[kept]), "y": compact(mark.y[kept]), "showlegend": False}
    return Scatter(
        mode="markers", marker=look, hovertemplate=f"{told}<extra></extra>", **where, **place.axes
    )


def draw_span(drawing: Drawing, span: Span, place: Place) -> None:
    """An arrow with two heads and its name."""
    (x, low), (end, high) = span.begin, span.end
    tail = {"ax": x, "ay": low, "axref": place.x, "ayref": place.y}
    ends = {"x": end, "y": high, **tail, **place.references}
    drawing.add_annotation(text="", arrowcolor=GREY, **ends, **ARROW)
    apart = {"xanchor": "left", "xshift": 4} if x == end else {"yanchor": "bottom"}
    middle = {"x": (x + end) / 2, "y": (low + high) / 2, **place.references}
    drawing.add_annotation(text=with_formulas(span.name), showarrow=False, **middle, **apart)


def legend(role: Role, named: dict[str, bool]) -> dict[str, Any]:
    """The name of a trace, shown where it is the first of it."""
    first = bool(role.title) and role.title not in named
    if role.title:
        named[role.title] = True
    return {"name": role.title, "legendgroup": role.title, "showlegend": first}


def thinned(samples: Values) -> slice:
    """Every so manieth sample, where there are too many to see."""
    return slice(None, None, max(-(-samples.size // MOST), 1))


def compact(samples: Any) -> Float[np.ndarray, "*any"]:
    """With as many digits as a drawing needs."""
    return np.asarray(samples, dtype=np.float32)
