"""Draws what a panel shows by plotly."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from jaxtyping import Float
from plotly.graph_objects import Figure as Drawing

from exoid.report.figures.style import area, bar, dots, line
from exoid.report.pictures.panel import (
    NEAR_TOP,
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
    Values,
)
from exoid.report.pictures.role import DIVERGING, GREY, Role
from exoid.report.words.typeset import tidy, with_formulas

MOST = 1500  # samples of a curve; more are not seen, and make the page heavy
ARROW: dict[str, Any] = {"arrowside": "end+start", "arrowhead": 2, "arrowwidth": 1}
COLOURS = [(at / (len(DIVERGING) - 1), colour) for at, colour in enumerate(DIVERGING)]


@dataclass(frozen=True)
class Place:
    """A panel's axes by plotly's names, in a drawing whose legend has the roles `named`."""

    drawing: Drawing
    x: str
    y: str
    panel: Panel
    named: set[Role]

    def add(self, kind: str, role: Role | None, **look: Any) -> None:
        """A trace; the first of a role is named in the legend."""
        legend: dict[str, Any] = {"name": "", "showlegend": False}
        if role is not None and role.title:
            first = role not in self.named
            legend = {"name": role.title, "legendgroup": role.title, "showlegend": first}
            self.named.add(role)
        self.drawing.add_trace({"type": kind, "xaxis": self.x, "yaxis": self.y, **legend, **look})

    def shape(self, look: dict[str, Any], low: float, high: float, upright: bool) -> None:
        """From one height to another, or upright from one place across; through the whole panel."""
        x, y = (low, high), (0, 1)
        xref, yref = self.x, f"{self.y} domain"
        if not upright:
            x, y, xref, yref = y, x, f"{self.x} domain", self.y
        ends = {"x0": x[0], "x1": x[1], "y0": y[0], "y1": y[1]}
        self.drawing.add_shape(ends | {"xref": xref, "yref": yref} | look)

    def say(self, words: str, x: float, y: float, **look: Any) -> None:
        """Words at a place."""
        where = {"x": x, "y": y, "xref": self.x, "yref": self.y, "showarrow": False}
        self.drawing.add_annotation(where | {"text": with_formulas(words)} | look)

    def point(self) -> str:
        """What is told of a point."""
        x, y = (tidy(axis.unit.replace("-", "")) for axis in (self.panel.across, self.panel.up))
        return f"%{{x:.4g}} {x}" + ("" if self.panel.up.hidden else f", %{{y:.4g}} {y}")


def draw_mark(mark: Mark, place: Place) -> None:
    """One thing."""
    match mark:
        case Line(role, x, y):
            draw_line(role, x, y, place)
        case Points():
            draw_points(mark, place)
        case Band(role, low, high, upright):
            place.shape(area(role.look), low, high, upright)
        case Rule(role, at, upright):
            place.shape({"type": "line", "line": line(role.look)}, at, at, upright)
        case Bars(role, rows, lengths, begin, words):
            told = f"{place.panel.across.title}: %{{x:.3g}}<extra></extra>"
            look = {"orientation": "h", "marker": bar(role.look), "hovertemplate": told}
            base = {} if begin is None else {"base": compact(begin)}
            beside = {"text": words, "textposition": "outside", "cliponaxis": False}
            more = base | (beside if words else {})
            place.add("bar", role, x=compact(lengths), y=compact(rows), **look, **more)
        case Cloud():
            draw_cloud(mark, place)
        case Span((x, low), (end, high), name):
            tail = {"ax": x, "ay": low, "axref": place.x, "ayref": place.y}
            place.say("", end, high, showarrow=True, arrowcolor=GREY, **tail, **ARROW)
            apart = {"xanchor": "left", "xshift": 4} if x == end else {"yanchor": "bottom"}
            place.say(name, (x + end) / 2, high - NEAR_TOP * (high - low), **apart)
        case Note(words, across, height):
            side = "left" if across < 0.1 else "right" if across > 0.9 else "center"
            place.say(words, across, height, xref=f"{place.x} domain", xanchor=side)


def draw_points(mark: Points, place: Place) -> None:
    """Markers with their errors."""
    ends = {"x": mark.x_error, "y": mark.y_error}
    look = {"color": mark.role.look.colour, "thickness": 1.6}
    errors = {
        f"error_{axis}": {"array": [error] * mark.x.size, **look}
        for axis, error in ends.items()
        if error
    }
    told: dict[str, Any] = {"hovertemplate": place.point()}
    if mark.told:
        text = [with_formulas(words) for words in mark.told]
        told = {"text": text, "hovertemplate": "%{text}<extra></extra>"}
    if mark.opens:
        told["customdata"] = mark.opens
    where = {"x": compact(mark.x), "y": compact(mark.y), "marker": dots(mark.role.look)}
    place.add("scatter", mark.role, mode="markers", **where, **told, **errors)


def draw_line(role: Role, x: Values, y: Values, place: Place) -> None:
    """A curve, along which the time is told once for all."""
    kept = thinned(x)
    look: dict[str, Any] = {"mode": "lines", "line": line(role.look)}
    if role.look.marker:
        look |= {"mode": "lines+markers", "marker": dots(role.look)}
    told = f"%{{y:.3f}} {tidy(place.panel.up.unit.replace('-', ''))}"
    look |= {"hovertemplate": told} if role.title else {"hoverinfo": "skip"}
    place.add("scatter", role, x=compact(x[kept]), y=compact(y[kept]), **look)


def draw_cloud(mark: Cloud, place: Place) -> None:
    """Marks that point up where the value is positive, in its colour."""
    kept = thinned(mark.x)
    value, (title, _, unit) = mark.value[kept], tidy(mark.label).rstrip("]").partition(" [")
    look = {
        "size": 7,
        "symbol": np.where(value > 0, "triangle-up", "triangle-down"),
        "color": compact(value),
        "colorscale": COLOURS,
        "cmin": -mark.most,
        "cmax": mark.most,
        "colorbar": {"title": {"text": unit}, "thickness": 12, "outlinewidth": 0},
    }
    told = f"{place.point()}: {title} %{{marker.color:.3f}} {unit}<extra></extra>"
    where = {"x": compact(mark.x[kept]), "y": compact(mark.y[kept]), "hovertemplate": told}
    place.add("scatter", None, mode="markers", marker=look, **where)


def thinned(samples: Values) -> slice:
    """Every so manieth sample, where there are too many to see."""
    return slice(None, None, max(-(-samples.size // MOST), 1))


def compact(samples: Values) -> Float[np.ndarray, "*any"]:
    """With as many digits as a drawing needs."""
    return np.asarray(samples, dtype=np.float32)
