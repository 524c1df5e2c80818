"""A drop with what clinicians read off it, marked on its curve."""

import numpy as np
from plotly.graph_objects import Figure as Drawing

from exoid.pendulum.drops import Drop
from exoid.recordings.landmarks.measure import Mark
from exoid.recordings.landmarks.rest import BAND as STILL
from exoid.report.figures.figure import Figure
from exoid.report.figures.marks import Mark as Look
from exoid.report.figures.marks import put
from exoid.report.figures.style import BAND, GREY, MEASURED_LINE, blank, curve
from exoid.report.plots.drops import AT_REST, CAME, CURVE, FLEXION, RELEASE, RESTING, marks
from exoid.report.tables.drops import shown_unit, value
from exoid.report.words.typeset import formula

HEIGHT = 340  # pixels
LOOKS = {
    RELEASE["label"]: {"color": RELEASE["color"], "symbol": "circle", "size": 9},
    FLEXION["label"]: {"color": FLEXION["color"], "symbol": "triangle-down", "size": 11},
    CAME["label"]: {"color": CAME["color"], "symbol": "square", "size": 9},
}
TOLD = ("first_flexion_amplitude", "plateau_amplitude", "relaxation_index")


def draw_drop(drop: Drop, number: int) -> Figure:
    """The angle over time [deg, s], release, turning points, amplitudes and the resting angle."""
    segment = drop.segment
    angle = segment.angle if segment.raw_angle is None else segment.raw_angle
    assert angle is not None  # a Segment has one or the other
    drawing, hover = blank(HEIGHT), "%{y:.2f} deg at %{x:.2f} s"
    look = {"name": CURVE["label"], "line": MEASURED_LINE, "hovertemplate": hover}
    curve(drawing, segment.time, np.degrees(angle), **look)
    draw_rest(drawing, drop)
    for name, places in places_of(drop).items():
        if places:
            times, angles = zip(
                *((each.time, np.degrees(each.value)) for each in places), strict=True
            )
            put(drawing, Look(name, LOOKS[name]), (times, angles), hovertemplate="%{y:.2f} deg")
    for name, symbol in (("first_flexion_amplitude", "A1"), ("plateau_amplitude", "A0")):
        draw_height(drawing, marks(drop, name), symbol)
    drawing.update_xaxes(title_text="time [s]")
    drawing.update_yaxes(title_text="angle [deg]")
    return Figure(f"drop-{number}", alternative(drop), caption(drop), drawing)


def places_of(drop: Drop) -> dict[str, tuple[Mark, ...]]:
    """What is marked, by its name in the legend."""
    flexions = dict.fromkeys(
        (*marks(drop, "first_flexion_amplitude")[1:], *marks(drop, "number_of_oscillations"))
    )
    return {
        RELEASE["label"]: marks(drop, "start_angle"),
        FLEXION["label"]: tuple(flexions),
        CAME["label"]: marks(drop, "time_to_rest")[1:],
    }


def draw_rest(drawing: Drawing, drop: Drop) -> None:
    """The resting angle, and what counts as rest around it."""
    for rest in marks(drop, "plateau_angle")[:1]:
        level, half = float(np.degrees(rest.value)), float(np.degrees(STILL))
        drawing.add_hrect(level - half, level + half, **BAND)
        drawing.add_hline(level, line={"color": CAME["color"], "width": 1.4, "dash": "6px,3px"})


def draw_height(drawing: Drawing, ends: tuple[Mark, ...], symbol: str) -> None:
    """An arrow between two angles, with its symbol."""
    if len(ends) < 2:
        return
    top, bottom = (float(np.degrees(each.value)) for each in ends[:2])
    at = {"x": ends[1].time, "y": bottom, "ax": ends[1].time, "ay": top}
    arrow = {"axref": "x", "ayref": "y", "arrowside": "end+start", "arrowhead": 2}
    drawing.add_annotation(text="", arrowcolor=GREY, arrowwidth=1, **at, **arrow)
    middle = {"x": ends[1].time, "y": (top + bottom) / 2}
    drawing.add_annotation(
        text=formula(symbol), showarrow=False, xanchor="left", xshift=4, **middle
    )


def alternative(drop: Drop) -> str:
    return (
        f"The angle of segment {drop.name} in deg over time in s, with release, turning points and "
        f"resting angle. {said(drop) or 'No amplitude could be read.'}"
    )


def caption(drop: Drop) -> str:
    rest = f" Dashed: {RESTING['label']}; grey: {AT_REST['label']}."
    return f"Segment {drop.name}. {said(drop)}{rest if marks(drop, 'plateau_angle') else ''}"


def said(drop: Drop) -> str:
    """The amplitudes and the index, as far as they were read."""
    read = [drop.measures[name] for name in TOLD if drop.measures[name].value is not None]
    words = [f"{each.title} {value(each)} {shown_unit(each.unit)}".strip() for each in read]
    return f"{'; '.join(words).capitalize()}." if words else ""
