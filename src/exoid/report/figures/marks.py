"""Points with error bars: what was chosen, what anatomy expects, what fits as well."""

from dataclasses import dataclass
from typing import Any

from plotly.graph_objects import Figure as Drawing
from plotly.graph_objects import Scatter

from exoid.report.figures.style import GREY, compact
from exoid.report.plots.style import CHOSEN as CHOSEN_PRINTED
from exoid.report.plots.style import EXPECTED as EXPECTED_PRINTED
from exoid.report.plots.style import MEMBER as MEMBER_PRINTED


@dataclass(frozen=True)
class Mark:
    """How one kind of point looks, and what it is called."""

    name: str
    look: dict[str, Any]


CHOSEN = Mark(
    CHOSEN_PRINTED["label"], {"color": CHOSEN_PRINTED["color"], "symbol": "diamond", "size": 11}
)
EXPECTED = Mark(
    EXPECTED_PRINTED["label"],
    {"color": GREY, "symbol": "square-open", "size": 11, "line": {"width": 2}},
)
LIMIT = Mark("limit", {"color": GREY, "symbol": "line-ns-open", "size": 22, "line": {"width": 2}})
MEMBER = Mark(
    "fits equally well",
    {"color": MEMBER_PRINTED["color"], "symbol": "circle", "size": 6, "opacity": 0.5},
)


def put(
    drawing: Drawing,
    mark: Mark,
    points: tuple[Any, Any],
    errors: tuple[float | None, float | None] = (None, None),
    **options: Any,
) -> None:
    """Points (x, y) with the errors of all of them."""
    bars = {
        f"error_{axis}": {"array": [error], "color": mark.look["color"], "thickness": 1.6}
        for axis, error in zip("xy", errors, strict=True)
        if error
    }
    x, y = (compact(each) for each in points)
    drawing.add_trace(
        Scatter(
            x=x,
            y=y,
            mode="markers",
            name=mark.name,
            legendgroup=mark.name,
            marker=mark.look,
            **bars,
            **options,
        )
    )
