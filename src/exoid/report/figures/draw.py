"""Draws a picture by plotly: its panels above each other."""

from dataclasses import dataclass
from math import log10
from typing import Any

from plotly.graph_objects import Figure as Drawing

from exoid.report.figures.marks import MOST, Place, draw_mark
from exoid.report.figures.style import TEMPLATE
from exoid.report.pictures.panel import Axis, Line, Note, Panel, Picture
from exoid.report.pictures.role import Role
from exoid.report.words.typeset import with_formulas

UNIT = 64  # pixels of a panel of size one
SHARED, APART = 8, 58  # pixels between panels on one axis, and between axes
LEGEND, EDGE, FOOT = 38, 12, 46  # pixels above the panels, and below them
APART_FROM_UNIT = "<br>"  # on a line of its own a label is no longer than a low panel, on paper too
FINE = 2.5  # powers of ten, below which 1, 2 and 5 of each are named


@dataclass(frozen=True, eq=False)
class Figure:
    """A picture as plotly draws it, and what is said below it."""

    drawing: Drawing
    height: int  # pixels
    caption: str

    @property
    def document(self) -> str:
        """The drawing as JSON; its angle brackets are escapes, so that no text ends a script."""
        text = self.drawing.to_json()
        assert text is not None  # what plotly drew, it can write
        return text


def draw(picture: Picture) -> Figure:
    """With its caption; where samples are too many to be seen, the caption says so."""
    panels = picture.panels
    shared = all(panel.across == panels[0].across for panel in panels)
    drawing, named = Drawing(layout={"template": TEMPLATE}), set[Role]()
    for number, panel in enumerate(panels, start=1):
        x, y = named_axis("x", 1 if shared else number), named_axis("y", number)
        place = Place(drawing, x, y, panel, named)
        absent = (Note(panel.absent, 0.5, 0.0),) if panel.absent else ()
        for mark in (*panel.marks, *absent):
            draw_mark(mark, place)
    gap, lowest = (SHARED, len(panels)) if shared else (APART, None)
    top = LEGEND if named else EDGE
    height = arrange(drawing, panels, gap, lowest) + top + FOOT
    drawing.update_layout(height=height, showlegend=bool(named), margin={"t": top})
    if any(panel.of(Line) for panel in panels):
        drawing.update_layout(hovermode="x unified", hoversubplots="axis")
    step = max([-(-each.x.size // MOST) for panel in panels for each in panel.of(Line)], default=1)
    drawn = "" if step <= 1 else f" One sample in {step} is drawn."
    return Figure(drawing, height, f"{picture.caption}{drawn}")


def arrange(drawing: Drawing, panels: tuple[Panel, ...], gap: int, lowest: int | None) -> int:
    """Panels above each other, and their height; all stand on the axis of number `lowest`."""
    heights = [UNIT * panel.size for panel in panels]
    whole = sum(heights) + gap * (len(panels) - 1)
    top = whole
    for number, (panel, height) in enumerate(zip(panels, heights, strict=True), start=1):
        domain = [max(top - height, 0.0) / whole, top / whole]
        up = {**edge(panel.up, APART_FROM_UNIT), "domain": domain}
        drawing.update_layout({f"yaxis{number}": up})
        if lowest is None or number == lowest:
            at = "" if lowest else number
            anchored = {
                **edge(panel.across),
                "anchor": named_axis("y", number),
                "hoverformat": ".4~g",
            }
            drawing.update_layout({f"xaxis{at}": anchored})
        top -= height + gap
    drawing.update_layout(barmode="overlay", bargap=0.25)
    return int(whole)


def titled(axis: Axis, apart: str) -> str:
    """title, unit; apart from each other."""
    title = with_formulas(axis.title)
    return f"{title}{apart}[{with_formulas(axis.unit)}]" if axis.unit else title


def named_axis(letter: str, number: int) -> str:
    """As plotly calls it: the first has no number."""
    return letter if number == 1 else f"{letter}{number}"


def edge(axis: Axis, apart: str = " ") -> dict[str, Any]:
    """An axis as plotly has it, its title `apart` from its unit."""
    if axis.hidden:
        return {"visible": False, "fixedrange": True, "range": axis.limits}
    made: dict[str, Any] = {"title": {"text": titled(axis, apart)}, "nticks": 6}
    if axis.limits is not None:
        made["range"] = axis.limits
    if axis.reversed:
        made["autorange"] = "reversed"
    if axis.logarithmic:
        made |= {"type": "log"}
    if axis.logarithmic and axis.limits is not None:
        low, high = map(log10, axis.limits)
        made |= {"range": [low, high], "dtick": "D2" if high - low < FINE else 1}
    if axis.ticks:
        places, names = zip(*axis.ticks, strict=True)
        shown = [with_formulas(name) for name in names]
        made |= {"tickvals": places, "ticktext": shown, "ticks": "", "showgrid": False}
    return made
